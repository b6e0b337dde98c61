#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <vector>

#include "render/readers/dicom_image.h"
#include "render/readers/dicom_structure.h"

namespace crest {

/// The pixels of a file, a frame at a time: stored values, a pixel's samples together, in the machine's byte
/// order. Nothing is inverted, scaled or coloured.
class DicomPixels {
 public:
  virtual ~DicomPixels() = default;
  /// Bytes that it may take at once.
  virtual std::uint64_t held_bytes() const = 0;
  /// Of a frame that was taken.
  virtual ScalarType type() const = 0;
  /// Holds until the next call. Throws Error when they cannot be read or decoded.
  virtual std::span<const std::byte> frame(std::size_t number) = 0;
  /// Whether a frame so far had anything in bits that are not among the stored ones.
  bool had_other_bits() const { return had_other_bits_; }

 protected:
  bool had_other_bits_ = false;
};

/// Of a file with so many frames, of which `image` is one. Throws Error when they are in a form that is not
/// read, or, as they are read, when they are others than that promises.
std::unique_ptr<DicomPixels> open_dicom_pixels(const DicomImage& image, std::size_t frames);
/// Those that are not compressed, and run lengths, a fragment a frame: without GDCM, which takes a file's
/// pixels all at once.
std::unique_ptr<DicomPixels> open_plain_pixels(const DicomImage& image, const DicomPlace& place);
std::unique_ptr<DicomPixels> open_run_lengths(const DicomImage& image, std::vector<DicomFragment> fragments);

/// Of stored values. Throws Error where the file says no such type, or bits that are not in it.
ScalarType dicom_type(const DicomImage& image, DicomNumbers numbers);

/// The stored bits of integers, which end at `high_bit`, as numbers of the type: bits about them may hold an
/// overlay, and the sign is the highest stored one (PS3.5, 8.1.1). Returns whether there is anything in bits
/// about them, but signs.
bool keep_stored_bits(std::span<std::byte> bytes, ScalarType type, unsigned stored, unsigned high_bit);

/// A pixel's samples together, of a frame that has them in a plane of each.
std::vector<std::byte> joined_planes(std::span<const std::byte> planes, std::size_t samples,
                                     std::size_t sample_bytes);

}  // namespace crest
