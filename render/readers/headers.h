#pragma once

#include <bit>
#include <filesystem>
#include <optional>
#include <string>

#include "render/readers/voxel_data.h"
#include "render/volume/convert.h"

namespace crest {

/// What is read of a file's header before ITK is let at it: ITK returns success for many truncated files, and
/// trusts headers. Sizes, types and geometry are ITK's to tell.
struct FileHeader {
  VoxelData data;
  std::optional<ScalarType> stored_type;  ///< of the voxels, where ITK may tell another
  /// Compressed MetaImage is inflated here, because MetaIO goes by a CompressedDataSize that is wrong in real
  /// files and drops the rest; in this byte order.
  std::optional<std::endian> inflate_here;
  LinearMap scaling;  ///< from the stored values to the volume's
};

// Each throws Error when the file is not of the format, or not in a form that can be read.
FileHeader read_nrrd_header(const std::filesystem::path& path);
FileHeader read_metaimage_header(const std::filesystem::path& path);
FileHeader read_nifti_header(const std::filesystem::path& path);
FileHeader read_mrc_header(const std::filesystem::path& path);
FileHeader read_vtk_header(const std::filesystem::path& path);

}  // namespace crest
