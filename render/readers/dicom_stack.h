#pragma once

#include <glm/mat3x3.hpp>
#include <string>
#include <vector>

#include "render/readers/dicom_image.h"

namespace crest {

/// Images that make a volume each, one for each frame: slices in order.
struct DicomStack {
  std::vector<std::vector<DicomImage>> frames;
  std::vector<std::string> frame_names;  ///< "echo time 4.6"; empty where there is one frame
  std::vector<std::string> frame_notes;  ///< of each frame, where there are some
  std::string note;                      ///< what was left out, and what the order is by
};

/// Makes one stack of a series' images: of one size and orientation, each place once in a frame. Others are
/// left out, which the note says. `name` begins the Error where nothing tells images of one place apart.
/// PS3.3, C.7.6.2.
DicomStack stack_dicom(const std::string& name, std::vector<DicomImage> images);

/// The geometry of slices in order.
struct DicomGeometry {
  glm::dvec3 spacing{1}, origin{0};
  glm::dmat3 direction{1};
  std::string note;  ///< what is not known, or not even
};
DicomGeometry geometry_of(const std::vector<DicomImage>& slices);

}  // namespace crest
