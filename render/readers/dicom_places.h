#pragma once

#include <gdcmDataSet.h>

#include <optional>
#include <vector>

#include "render/readers/dicom_image.h"

// Where images lie, and where the frames of a file that tells but the first one's place.
namespace crest {

std::optional<glm::dvec3> dicom_position(const gdcm::DataSet& set);
/// Both of its axes with length 1.
void take_dicom_orientation(const gdcm::DataSet& set, DicomImage& image);

/// Of a dose's planes: their distances from the first one (PS3.3, C.8.8.3.2).
void take_dicom_offsets(const gdcm::DataSet& set, std::vector<DicomImage>& images);
/// Of nuclear medicine: which slice each frame is of, and what else it is of (PS3.3, C.8.4.8).
void take_dicom_slice_numbers(const gdcm::DataSet& set, std::vector<DicomImage>& images);
/// Of frames that are all in one place, the file's: they follow each other by the distance between slices,
/// to the other side where that is negative (PS3.3, C.8.4.15). Where it is not known, the first one alone has
/// a place.
void place_dicom_frames(std::vector<DicomImage>& images);

}  // namespace crest
