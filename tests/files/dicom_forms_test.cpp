#include "dicom_elements.h"
#include "render/files/load.h"

namespace crest::test {
namespace {

using enum ScalarType;

/// The same elements without their types, as files are coded that do not say how.
std::string without_types(const std::string& bytes) {
  std::string all;
  const auto length_at = [&](std::size_t at, std::size_t size) {
    std::size_t length = 0;
    for (std::size_t i = size; i-- > 0;) length = length << 8 | static_cast<unsigned char>(bytes[at + i]);
    return length;
  };
  for (std::size_t at = 0; at < bytes.size();) {
    const bool is_long = bytes.substr(at + 4, 2) == "OW";
    const std::size_t length = is_long ? length_at(at + 8, 4) : length_at(at + 6, 2),
                      begin = at + (is_long ? 12 : 8);
    all += bytes.substr(at, 4) + bytes_of({double(length)}, uint32) + bytes.substr(begin, length);
    at = begin + length;
  }
  return all;
}

/// Files that are not quite as the standard says, and that other programs read.
class DicomForms : public FileTest {
 protected:
  void expect_read(const std::string& name, const std::string& bytes) const {
    const std::string file = write(name, bytes);
    const Volume volume = load_volume(name.starts_with("f/") ? path("f") : file);
    ASSERT_EQ(volume.grid.dims, glm::ivec3(3, 2, 3));
    for (int k = 0; k < 3; ++k) EXPECT_EQ(volume.at(2, 1, k), float(10 * k + 5)) << k;
  }
  const std::string elements = image(3).bytes();
};

TEST_F(DicomForms, AFileNeedsNoHead) {
  constexpr std::size_t preamble = 132;
  const std::string untyped = without_types(elements);
  const std::string head = dicom_head_of_two();
  for (const char* name : {"a.dcm", "f/a"}) {
    for (const std::string* bytes : {&elements, &untyped}) {
      expect_read(name, *bytes);
      expect_read(name, head.substr(0, preamble) + *bytes);
    }
    expect_read(name, head.substr(preamble) + elements);
  }
  expect_error(write("b.dcm", elements.substr(0, elements.size() - 2)), {"b.dcm", "ends within"});
  expect_error(write("c.dcm", "\x08" + std::string(200, 'x')), {"not a DICOM file"});
}

TEST_F(DicomForms, WhatFollowsThePixelsDoesNotCount) {
  for (const std::string& more : {std::string(100, '\0'), std::string(5, '\0'), std::string("no element")})
    expect_read("a.dcm", dicom_head_of_two() + elements + more);
}

TEST_F(DicomForms, LengthsMayBeOdd) {
  const std::string odd = bytes_of({0x19, 0x1001}, uint16) + "LO" + bytes_of({3}, uint16) + "abc";
  const std::size_t behind = elements.find(std::string("\x20\0\x0d\0", 4));
  expect_read("a.dcm", dicom_head_of_two() + elements.substr(0, behind) + odd + elements.substr(behind));
}

// An item of elements without types, in a sequence that says neither its type nor its length.
TEST_F(DicomForms, SequencesOfNoTypeAreCodedWithoutTypes) {
  const auto mark = [](unsigned member, std::uint32_t length) {
    return bytes_of({double(0xfffe), double(member)}, uint16) + bytes_of({double(length)}, uint32);
  };
  constexpr std::uint32_t unsaid = 0xffffffff;
  const std::string inner = without_types(dicom_element(8, 0x100, "SH", "abcd"));
  const std::string sequence = bytes_of({0x19, 0x1001}, uint16) + "UN" + std::string(2, '\0') +
                               bytes_of({double(unsaid)}, uint32) + mark(0xe000, unsaid) + inner +
                               mark(0xe00d, 0) + mark(0xe0dd, 0);
  const std::size_t behind = elements.find(std::string("\x20\0\x0d\0", 4));
  expect_read("a.dcm", dicom_head_of_two() + elements.substr(0, behind) + sequence + elements.substr(behind));
}

TEST_F(DicomForms, NumbersMayBeOfNoType) {
  std::string bytes = elements;
  const std::string rows = dicom_element(0x28, 0x10, "US", dicom_us(2));
  const std::string unknown =
      bytes_of({0x28, 0x10}, uint16) + "UN" + std::string(2, '\0') + bytes_of({2}, uint32) + dicom_us(2);
  bytes.replace(bytes.find(rows), rows.size(), unknown);
  expect_read("a.dcm", dicom_head_of_two() + bytes);
}

}  // namespace
}  // namespace crest::test
