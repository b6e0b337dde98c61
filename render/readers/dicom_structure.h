#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

namespace crest {

/// What a DICOM file's elements tell before GDCM is let at it, which ends the program on some truncated files
/// and fills in the pixels of others.
struct DicomStructure {
  bool has_image = false;                    ///< rows, and pixels
  bool has_real_pixels = false;              ///< Float Pixel Data, or Double Float Pixel Data
  std::optional<std::uint64_t> pixel_bytes;  ///< of uncompressed pixels
};

/// Goes through the elements to the file's end. Throws Error when they are damaged, or it ends within one.
DicomStructure read_dicom_structure(const std::filesystem::path& path);

}  // namespace crest
