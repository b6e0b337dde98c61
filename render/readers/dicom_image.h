#pragma once

#include <array>
#include <filesystem>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

#include "render/volume/convert.h"

namespace crest {

/// What may tell images of one place apart, in the order in which it is looked for: "echo time", "4.6".
struct DicomMark {
  std::string name, value;
};

/// One image of a DICOM file, a frame where the file has several: what its elements say, without its pixels.
struct DicomImage {
  std::filesystem::path file;
  std::size_t frame = 0;
  std::string series, instance, description, modality;
  std::uint64_t columns = 0, rows = 0, samples = 1;
  std::uint64_t bits = 16;  ///< that a sample is stored in
  bool is_signed = false;
  bool is_real = false;                                  ///< its pixels are floating-point numbers
  std::optional<glm::dvec3> position;                    ///< of the first pixel's centre, in mm
  std::optional<std::array<glm::dvec3, 2>> orientation;  ///< along rows (x) and along columns (y)
  std::optional<glm::dvec2> spacing;                     ///< in mm, x and y
  bool spacing_at_detector = false;                      ///< not in the patient
  std::optional<double> slice_distance, thickness;       ///< mm
  std::optional<double> number;                          ///< that it is sorted by where it has no position
  bool is_time = false;                                  ///< the file's frames follow each other in time
  LinearMap scaling;                                     ///< from stored values to the modality's
  std::string photometric;
  bool has_value_table = false;  ///< a table maps its values, which is not applied
  std::vector<DicomMark> marks;
};

/// The images of a file; none where it holds none. Throws Error for what is damaged.
std::vector<DicomImage> read_dicom_images(const std::filesystem::path& file);

/// The files that a DICOMDIR names, in its order.
std::vector<std::filesystem::path> files_of_dicomdir(const std::filesystem::path& dicomdir);

/// The decoded pixels of all frames of a file, one after another, samples of a pixel together, in the
/// machine's byte order.
struct DicomPixels {
  ScalarType type = ScalarType::uint16;
  std::vector<std::byte> bytes;
};
/// Stored values: nothing is inverted, scaled or coloured. Throws Error when they cannot be decoded, or are
/// not `count` values.
DicomPixels read_dicom_pixels(const std::filesystem::path& file, std::uint64_t count);
/// The same of an image whose pixels are real, which GDCM does not take for one.
DicomPixels read_dicom_reals(const std::filesystem::path& file, std::uint64_t count);

}  // namespace crest
