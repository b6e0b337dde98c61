#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "render/volume/voxel_data.h"

namespace crest {

/// What is read of a file's header before ITK is let at it: ITK returns success for many truncated files, and
/// trusts headers. Sizes, types and geometry are ITK's to tell.
struct FileHeader {
  VoxelData data;
  std::optional<ScalarType> stored_type;  ///< where ITK tells another, because it scales the values
  bool bytes_are_signed = false;          ///< where ITK reads them as uint8
  std::string note;
};

// Each throws Error when the file is not of the format, or not in a form that can be read.
FileHeader read_nrrd_header(const std::filesystem::path& path);
FileHeader read_metaimage_header(const std::filesystem::path& path);
FileHeader read_nifti_header(const std::filesystem::path& path);
FileHeader read_mrc_header(const std::filesystem::path& path);
FileHeader read_vtk_header(const std::filesystem::path& path);

}  // namespace crest
