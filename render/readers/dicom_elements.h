#pragma once

#include <gdcmDataSet.h>

#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

namespace crest {

/// An element as text without its padding; empty where it is not there.
std::string dicom_text(const gdcm::DataSet& set, gdcm::Tag tag);
/// The numbers of a decimal or integer string.
std::vector<double> dicom_numbers(const gdcm::DataSet& set, gdcm::Tag tag);
std::optional<double> dicom_number(const gdcm::DataSet& set, gdcm::Tag tag);
/// A binary number: US, UL or FD.
std::optional<double> dicom_binary(const gdcm::DataSet& set, gdcm::Tag tag);
/// The 16-bit numbers (US) of an element.
std::vector<double> dicom_whole_numbers(const gdcm::DataSet& set, gdcm::Tag tag);
/// The data sets of a sequence's items; none where it is not there.
std::vector<gdcm::DataSet> dicom_items(const gdcm::DataSet& set, gdcm::Tag tag);

}  // namespace crest
