#pragma once

#include <filesystem>

namespace crest {

/// Whether the file begins as DICOM files do.
bool is_dicom(const std::filesystem::path& path);
/// Whether it is named as an image is that a stack may hold.
bool is_image(const std::filesystem::path& path);
/// Whether it is named as an image that needs no OpenImageIO: TIFF, PNG, JPEG, Netpbm.
bool is_plain_image(const std::filesystem::path& path);

}  // namespace crest
