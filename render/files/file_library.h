#pragma once

#include <filesystem>
#include <glm/vec2.hpp>
#include <string>

#include "render/files/file_request.h"
#include "render/files/image.h"
#include "render/volume/volume.h"

namespace crest {

/// The forms of volume files that need a library.
enum class FileForm {
  nrrd,
  metaimage,
  nifti,
  mrc,
  vtk,
  vti,
  npy,
  dicom_file,
  dicom_series,
  image_pages,
  image_folder
};

/// What GDCM, OpenImageIO and others do for Crest. They load many libraries, which takes a while: so
/// they live in a library of their own (render/files), which is loaded when it is first asked for.
struct FileLibrary {
  /// Fills the grid, the values, the file's type, the direction and the note. Throws Error.
  Volume (*read_volume)(FileForm form, const FileRequest& request);
  bool (*has_dicom)(const std::filesystem::path& folder);
  bool (*has_images)(const std::filesystem::path& folder);

  /// An image file's bytes, in the format that `path` ends with: 8-bit RGB, or 32-bit float RGBA; row 0 at
  /// the top. `preset` is kept as text, unless it is empty. Throws Error.
  std::string (*encode_rgb8)(const std::filesystem::path& path, glm::ivec2 size, const void* pixels,
                             const std::string& preset);
  std::string (*encode_rgba32f)(const std::filesystem::path& path, glm::ivec2 size, const void* pixels,
                                const std::string& preset);
  /// As preset_in_picture().
  std::string (*preset_in_picture)(const std::filesystem::path& path);
  /// As read_image().
  Image (*read_image)(const std::filesystem::path& path);
};

/// Throws Error when it cannot be loaded. Any thread may ask.
const FileLibrary& file_library();

}  // namespace crest
