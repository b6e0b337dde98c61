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
  std::uint64_t bits = 16;                        ///< that a sample is stored in
  std::uint64_t bits_stored = 16, high_bit = 15;  ///< those of them that are the sample's
  bool is_signed = false;
  bool is_real = false;                ///< its pixels are floating-point numbers
  bool has_planes = false;             ///< each frame, of the first samples, then of the second ones
  std::optional<glm::dvec3> position;  ///< of the first pixel's centre, in mm
  std::optional<std::array<glm::dvec3, 2>> orientation;  ///< along rows (x) and along columns (y)
  bool is_taken_as_axial = false;                        ///< its file does not say the orientation
  std::optional<glm::dvec2> spacing;                     ///< in mm, x and y
  bool spacing_at_detector = false;                      ///< not in the patient
  std::optional<double> slice_distance, thickness;       ///< mm; the first one's sign is a direction
  std::optional<double> slice_number;                    ///< from 1, as a file with several says it
  bool is_placed_by_number = false;                      ///< and not by a position of its own
  std::optional<double> number;                          ///< that it is sorted by where it has no position
  bool is_time = false;                                  ///< the file's frames follow each other in time
  LinearMap scaling;                                     ///< from stored values to the modality's
  std::vector<LinearMap> world;                          ///< to others, as to real-world values
  bool is_tile = false;                                  ///< of a larger image, as of a microscope's slide
  bool is_mosaic = false;  ///< holds its slices side by side, unless it has a place each
  bool is_empty = false;   ///< is not in the file: its pixels are 0
  std::string photometric;
  bool has_value_table = false;  ///< a table maps its values, which is not applied
  std::vector<DicomMark> marks;
};

/// Whether two neighbouring pixels have a luma each, and share their two colour differences.
inline bool shares_colours(const DicomImage& image) {
  return image.photometric.ends_with("_422") && image.samples == 3;
}

/// The images of a file; none where it holds none. Throws Error for what is damaged, and for
/// pixels that are not compressed and fewer than promised.
std::vector<DicomImage> read_dicom_images(const std::filesystem::path& file);

/// The files that a DICOMDIR names, in its order.
std::vector<std::filesystem::path> files_of_dicomdir(const std::filesystem::path& dicomdir);

}  // namespace crest
