#include "render/readers/dicom_elements.h"

#include <gdcmSequenceOfItems.h>

#include <cstring>

#include "render/files/header_text.h"
#include "render/volume/query.h"

namespace crest {
namespace {

std::string bytes_of(const gdcm::DataSet& set, gdcm::Tag tag) {
  if (!set.FindDataElement(tag)) return {};
  const gdcm::ByteValue* value = set.GetDataElement(tag).GetByteValue();
  return value ? std::string(value->GetPointer(), value->GetLength()) : std::string();
}

}  // namespace

std::string dicom_text(const gdcm::DataSet& set, gdcm::Tag tag) {
  std::string text = bytes_of(set, tag);
  text.resize(std::min(text.size(), text.find('\0')));
  return one_line(text);
}

std::vector<double> dicom_numbers(const gdcm::DataSet& set, gdcm::Tag tag) {
  const std::string text = dicom_text(set, tag);
  std::vector<double> numbers;
  for (std::string_view part : split(text, '\\')) {
    part = trim(part);
    if (part.starts_with('+')) part.remove_prefix(1);
    const auto number = to_number(part);
    if (!number) return {};
    numbers.push_back(*number);
  }
  return numbers;
}

std::optional<double> dicom_number(const gdcm::DataSet& set, gdcm::Tag tag) {
  const auto numbers = dicom_numbers(set, tag);
  return numbers.empty() ? std::nullopt : std::optional(numbers[0]);
}

std::optional<double> dicom_binary(const gdcm::DataSet& set, gdcm::Tag tag) {
  const std::string bytes = bytes_of(set, tag);
  const auto as = [&](auto value) {
    std::memcpy(&value, bytes.data(), sizeof value);
    return double(value);
  };
  if (bytes.size() == 2) return as(std::uint16_t());
  if (bytes.size() == 4) return as(std::uint32_t());
  if (bytes.size() == 8) return as(double());
  return std::nullopt;
}

std::vector<double> dicom_whole_numbers(const gdcm::DataSet& set, gdcm::Tag tag) {
  const std::string bytes = bytes_of(set, tag);
  std::vector<double> numbers;
  for (std::size_t at = 0; at + sizeof(std::uint16_t) <= bytes.size(); at += sizeof(std::uint16_t)) {
    std::uint16_t number;
    std::memcpy(&number, bytes.data() + at, sizeof number);
    numbers.push_back(number);
  }
  return numbers;
}

std::vector<gdcm::DataSet> dicom_items(const gdcm::DataSet& set, gdcm::Tag tag) {
  std::vector<gdcm::DataSet> items;
  if (!set.FindDataElement(tag)) return items;
  const auto sequence = set.GetDataElement(tag).GetValueAsSQ();
  if (!sequence) return items;
  for (gdcm::SequenceOfItems::SizeType i = 1; i <= sequence->GetNumberOfItems(); ++i)
    items.push_back(sequence->GetItem(i).GetNestedDataSet());
  return items;
}

}  // namespace crest
