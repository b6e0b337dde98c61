#include "render/readers/dicom_places.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "render/readers/dicom_elements.h"

namespace crest {
namespace {

using gdcm::Tag;

/// Of a vector with a number for each frame.
constexpr std::pair<std::uint16_t, const char*> vectors[] = {
    {0x0010, "energy window"}, {0x0020, "detector"},  {0x0030, "phase"},
    {0x0060, "R-R interval"},  {0x0070, "time slot"}, {0x0100, "time slice"}};

glm::dvec3 normal_of(const DicomImage& image) {
  return glm::cross((*image.orientation)[0], (*image.orientation)[1]);
}

}  // namespace

std::optional<glm::dvec3> dicom_position(const gdcm::DataSet& set) {
  const auto v = dicom_numbers(set, Tag(0x0020, 0x0032));
  return v.size() == 3 ? std::optional(glm::dvec3(v[0], v[1], v[2])) : std::nullopt;
}

void take_dicom_orientation(const gdcm::DataSet& set, DicomImage& image) {
  const auto v = dicom_numbers(set, Tag(0x0020, 0x0037));
  if (v.size() != 6) return;
  const glm::dvec3 along_row(v[0], v[1], v[2]), along_column(v[3], v[4], v[5]);
  if (glm::length(along_row) > 0 && glm::length(along_column) > 0)
    image.orientation = {{glm::normalize(along_row), glm::normalize(along_column)}};
}

void take_dicom_offsets(const gdcm::DataSet& set, std::vector<DicomImage>& images) {
  const auto offsets = dicom_numbers(set, Tag(0x3004, 0x000c));
  if (offsets.size() != images.size() || !images[0].position || !images[0].orientation) return;
  const glm::dvec3 first = *images[0].position, normal = normal_of(images[0]);
  const bool relative = offsets[0] == 0;
  for (std::size_t i = 0; i < images.size(); ++i)
    images[i].position = relative ? first + offsets[i] * normal : glm::dvec3(first.x, first.y, offsets[i]);
}

void take_dicom_slice_numbers(const gdcm::DataSet& set, std::vector<DicomImage>& images) {
  const auto slices = dicom_whole_numbers(set, Tag(0x0054, 0x0080));
  if (slices.size() != images.size()) return;
  for (std::size_t i = 0; i < images.size(); ++i) images[i].slice_number = slices[i];
  for (const auto& [member, name] : vectors) {
    const auto numbers = dicom_whole_numbers(set, Tag(0x0054, member));
    for (std::size_t i = 0; numbers.size() == images.size() && i < images.size(); ++i)
      images[i].marks.push_back({name, fmt::format("{}", numbers[i])});
  }
  const auto detectors = dicom_items(set, Tag(0x0054, 0x0022));
  for (DicomImage& image : images) {
    if (detectors.empty() || image.orientation) continue;
    take_dicom_orientation(detectors[0], image);
    image.position = dicom_position(detectors[0]);
  }
}

void place_dicom_frames(std::vector<DicomImage>& images) {
  const DicomImage first = images[0];
  const double distance = first.slice_distance.value_or(0);
  constexpr double longest = 1e6;  // mm, so that places can be counted with
  const bool known =
      first.position && first.orientation && distance != 0 && std::abs(distance) < longest && !first.is_time;
  for (DicomImage& image : images) {
    image.is_placed_by_number = known;
    const double number = image.slice_number.value_or(double(image.frame + 1));
    if (known)
      image.position = *first.position + (number - 1) * distance * normal_of(first);
    else if (image.frame > 0 || image.slice_number)
      image.position.reset();  // their numbers alone tell the order
  }
}

}  // namespace crest
