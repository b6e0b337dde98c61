#pragma once

#include <array>
#include <filesystem>
#include <glm/vec2.hpp>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "render/files/file_request.h"
#include "render/files/image.h"
#include "render/volume/volume.h"

namespace crest {

/// What a reader is asked for: the forms of volume files, and what a picture holds.
enum class FileForm {
  nrrd,
  metaimage,
  nifti,
  mrc,
  vtk,
  vti,
  pvti,
  npy,
  dicom_file,
  dicom_series,
  image_pages,
  image_folder,
  picture,
  picture_preset
};
inline constexpr std::array<std::string_view, 14> file_form_names{
    "nrrd", "metaimage",  "nifti",        "mrc",         "vtk",          "vti",     "pvti",
    "npy",  "dicom_file", "dicom_series", "image_pages", "image_folder", "picture", "picture_preset"};

// GDCM brings some 20 libraries, and OpenImageIO 260, which take a fifth of a second to load. Each lies in a
// module of its own (render/readers), as do the small libraries of TIFF, PNG and JPEG; it is loaded when it
// is first asked for. Only the reader's program (render/reader) reads with them, since a damaged file may
// take them down; the program itself writes pictures. The other forms are read by code in the reader's
// program.

/// GDCM's, or that of images as pages: libtiff's, libpng's and libjpeg's.
struct VolumeModule {
  /// Of a file, or of a folder: fills the grid, the values, the file's type, the direction and the note.
  /// Throws Error.
  Volume (*read)(FileForm form, const FileRequest& request);
};

class PageFile;

/// OpenImageIO's.
struct ImageModule {
  /// An image of another kind than the page module's own.
  std::unique_ptr<PageFile> (*open_pages)(const std::filesystem::path& path);
  std::string (*preset_in_picture)(const std::filesystem::path& path);
  Image (*read_image)(const std::filesystem::path& path);

  /// An image file's bytes, in the format that `path` ends with: 8-bit RGB, or 32-bit float RGBA; row 0 at
  /// the top. `preset` is kept as text, unless it is empty. Throws Error.
  std::string (*encode_rgb8)(const std::filesystem::path& path, glm::ivec2 size, const void* pixels,
                             const std::string& preset);
  std::string (*encode_rgba32f)(const std::filesystem::path& path, glm::ivec2 size, const void* pixels,
                                const std::string& preset);
};

/// Each throws Error when it cannot be loaded. Any thread may ask.
const VolumeModule& dicom_module();
const VolumeModule& page_module();
const ImageModule& image_module();

}  // namespace crest
