#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

namespace crest {

enum class DicomNumbers { integers, float32, float64 };

/// Where the pixels of a file lie that stores them as they are.
struct DicomPlace {
  std::uint64_t begin = 0, bytes = 0;
  DicomNumbers numbers = DicomNumbers::integers;
  std::size_t swapped = 1;  ///< the bytes of so many are in the other order: 2 of each 16-bit word
};

/// A part of pixels that are compressed.
struct DicomFragment {
  std::uint64_t begin = 0, bytes = 0;
};

/// What a DICOM file's elements tell before GDCM is let at it, which ends the program on some truncated files
/// and fills in the pixels of others.
struct DicomStructure {
  bool has_image = false;                ///< rows, and pixels
  std::uint32_t pixel_tag = 0;           ///< of the element that holds them: 0x7fe00010
  std::optional<DicomPlace> pixels;      ///< where they are not compressed
  std::vector<DicomFragment> fragments;  ///< else
  std::uint64_t end = 0;                 ///< where they end: what is behind them is of no use
  bool is_run_lengths = false;           ///< "RLE Lossless"
};

/// Goes through the elements to the pixels' end, or to the file's. Throws Error when they are damaged, or it
/// ends within one.
DicomStructure read_dicom_structure(const std::filesystem::path& path);

}  // namespace crest
