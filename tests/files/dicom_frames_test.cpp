#include <fmt/core.h>

#include <algorithm>
#include <glm/geometric.hpp>

#include "files.h"
#include "render/files/load.h"

namespace crest::test {
namespace {

using enum ScalarType;

const auto element = dicom_element;

/// A sequence of one item or more, each with its length.
std::string sequence(unsigned group, unsigned number, const std::vector<std::string>& items) {
  std::string content;
  for (const std::string& item : items) {
    content += std::string("\xfe\xff\x00\xe0", 4);
    append_value(content, double(item.size()), uint32, std::endian::little);
    content += item;
  }
  return element(group, number, "SQ", content);
}

/// What a functional group of an enhanced file says of a frame.
struct FrameSays {
  std::string position, orientation = {}, slope = "1", intercept = "0";
  int time = 1, segment = 0;
};

std::string group_of(const FrameSays& frame) {
  std::string group;
  std::string time;
  append_value(time, frame.time, uint32, std::endian::little);
  group += sequence(0x20, 0x9111, {element(0x20, 0x9128, "UL", time)});
  if (frame.segment > 0) group += sequence(0x62, 0xa, {element(0x62, 0xb, "US", dicom_us(frame.segment))});
  group += sequence(0x20, 0x9113, {element(0x20, 0x32, "DS", frame.position)});
  if (!frame.orientation.empty())
    group += sequence(0x20, 0x9116, {element(0x20, 0x37, "DS", frame.orientation)});
  return group + sequence(0x28, 0x9145,
                          {element(0x28, 0x1052, "DS", frame.intercept) +
                           element(0x28, 0x1053, "DS", frame.slope) + element(0x28, 0x1054, "LO", "US")});
}

/// Frames of 4x3 pixels, 100 f + i in frame f. What all frames share has `orientation`, unless it is empty.
std::string enhanced(const std::vector<FrameSays>& frames, const std::string& orientation) {
  std::string shared =
      sequence(0x28, 0x9110, {element(0x18, 0x50, "DS", "9") + element(0x28, 0x30, "DS", "2\\1")});
  if (!orientation.empty()) shared += sequence(0x20, 0x9116, {element(0x20, 0x37, "DS", orientation)});
  std::vector<std::string> groups;
  std::string pixels;
  for (std::size_t f = 0; f < frames.size(); ++f) {
    groups.push_back(group_of(frames[f]));
    for (int i = 0; i < 12; ++i) append_value(pixels, double(100 * f) + i, int16, std::endian::little);
  }
  return dicom_head("1.2.840.10008.5.1.4.1.1.4.1", "1.2.3.4") + element(8, 0x60, "CS", "MR") +
         element(0x20, 0xd, "UI", "1.2") + element(0x20, 0xe, "UI", "1.2.3") +
         element(0x28, 2, "US", dicom_us(1)) + element(0x28, 4, "CS", "MONOCHROME2") +
         element(0x28, 8, "IS", std::to_string(frames.size())) + element(0x28, 0x10, "US", dicom_us(3)) +
         element(0x28, 0x11, "US", dicom_us(4)) + element(0x28, 0x100, "US", dicom_us(16)) +
         element(0x28, 0x101, "US", dicom_us(16)) + element(0x28, 0x102, "US", dicom_us(15)) +
         element(0x28, 0x103, "US", dicom_us(1)) + sequence(0x5200, 0x9229, {shared}) +
         sequence(0x5200, 0x9230, groups) + element(0x7fe0, 0x10, "OW", pixels);
}

class DicomFrames : public FileTest {};

TEST_F(DicomFrames, EachHasItsPlaceAndScale) {
  const int place[] = {2, 0, 3, 1};  // of frame f among the slices
  for (const bool in_each : {false, true}) {
    const std::string orientation = "0\\1\\0\\0\\0\\1";  // to the back, then up: slices go to the left
    std::vector<FrameSays> frames;
    for (int f = 0; f < 4; ++f) {
      frames.push_back({fmt::format("{}\\20\\30", 10 + 2.5 * place[f]), in_each ? orientation : "",
                        fmt::format("{}", f + 1), fmt::format("{}", -7 * f)});
    }
    const Volume volume = load_volume(write("e.dcm", enhanced(frames, in_each ? "" : orientation)));
    EXPECT_EQ(volume.grid.dims, glm::ivec3(4, 3, 4));
    EXPECT_LT(glm::distance(volume.grid.spacing, glm::dvec3(1, 2, 2.5)), 1e-9);
    EXPECT_LT(glm::distance(volume.grid.origin, glm::dvec3(10, 20, 30)), 1e-9);
    EXPECT_EQ(volume.direction, glm::dmat3(glm::dvec3(0, 1, 0), glm::dvec3(0, 0, 1), glm::dvec3(1, 0, 0)));
    EXPECT_TRUE(volume.is_in_patient);
    for (int f = 0; f < 4; ++f)
      for (int j = 0; j < 3; ++j)
        for (int i = 0; i < 4; ++i)
          EXPECT_EQ(volume.at(i, j, place[f]), float((f + 1) * (100 * f + 4 * j + i) - 7 * f));
  }
}

TEST_F(DicomFrames, ThoseOfTwoFilesMayTakeTurns) {
  for (int file = 0; file < 2; ++file) {
    std::vector<FrameSays> frames;
    for (int f = 0; f < 3; ++f)
      frames.push_back({fmt::format("10\\20\\{}", 2 * f + file), "", "1", fmt::format("{}", 1000 * file)});
    write(fmt::format("series/{}.dcm", file), enhanced(frames, "1\\0\\0\\0\\1\\0"));
  }
  Reading reading;
  std::vector<double> shares;
  reading.progress = [&](double share) { shares.push_back(share); };
  const Volume volume = load_volume(path("series"), reading);
  ASSERT_EQ(volume.grid.dims.z, 6);
  for (int k = 0; k < 6; ++k) EXPECT_EQ(volume.at(1, 2, k), float(100 * (k / 2) + 1000 * (k % 2) + 9));
  EXPECT_TRUE(std::ranges::is_sorted(shares));
  const Volume part = load_volume(path("series") + "?crop=:,:,1:5");
  for (int k = 0; k < 4; ++k) EXPECT_EQ(part.at(1, 2, k), volume.at(1, 2, k + 1));
}

TEST_F(DicomFrames, TimesOfAPlaceAreTakenApart) {
  std::vector<FrameSays> frames;
  for (int f = 0; f < 6; ++f) frames.push_back({fmt::format("10\\20\\{}", f / 2), "", "1", "0", 2 - f % 2});
  const std::string file = write("e.dcm", enhanced(frames, "1\\0\\0\\0\\1\\0"));
  expect_error(file, {"2 frames (time 1, time 2)", "?frame=0"});
  const Volume volume = load_volume(file + "?frame=0");  // the odd ones in the file
  EXPECT_EQ(volume.grid.dims.z, 3);
  for (int k = 0; k < 3; ++k) EXPECT_EQ(volume.at(1, 2, k), float(100 * (2 * k + 1) + 9));
}

TEST_F(DicomFrames, SegmentsHaveTheirOwnSlices) {
  std::vector<FrameSays> frames;
  for (const auto& [segment, z] : {std::pair(2, 4), {1, 1}, {1, 2}, {2, 3}, {1, 0}})
    frames.push_back({fmt::format("10\\20\\{}", z), "", "1", "0", 1, segment});
  const std::string file = write("seg.dcm", enhanced(frames, "1\\0\\0\\0\\1\\0"));
  expect_error(file, {"2 frames (segment 1, segment 2)"});
  const Volume first = load_volume(file + "?frame=0"), second = load_volume(file + "?frame=1");
  ASSERT_EQ(first.grid.dims, glm::ivec3(4, 3, 3));
  ASSERT_EQ(second.grid.dims, glm::ivec3(4, 3, 2));  // they have no slice in common
  EXPECT_EQ(second.grid.origin.z, 3);
  const int of_first[] = {4, 1, 2}, of_second[] = {3, 0};
  for (int k = 0; k < 3; ++k) EXPECT_EQ(first.at(1, 0, k), float(100 * of_first[k] + 1));
  for (int k = 0; k < 2; ++k) EXPECT_EQ(second.at(1, 0, k), float(100 * of_second[k] + 1));
}

TEST_F(DicomFrames, ADicomdirsFilesAreFollowed) {
  std::vector<std::string> records;
  for (int slice = 0; slice < 3; ++slice) {
    const std::vector<std::int16_t> pixels(12, std::int16_t(70 * slice));
    write(fmt::format("set/images/i{}", slice), dicom_slice(4, 3, 2 * slice, slice + 1, pixels));
    records.push_back(element(4, 0x1430, "CS", "IMAGE") +
                      element(4, 0x1500, "CS", fmt::format("IMAGES\\I{}", slice)));
  }
  std::string head = dicom_head("1.2.840.10008.1.3.10", "1.2.9");
  head.resize(head.find(std::string("\x08\x00\x16\x00", 4)));  // it has no such group
  write("set/DICOMDIR", head + element(4, 0x1130, "CS", "DISC") + sequence(4, 0x1220, records));
  const Volume volume = load_volume(path("set"));
  EXPECT_EQ(volume.grid.dims, glm::ivec3(4, 3, 3));
  EXPECT_EQ(volume.grid.spacing, glm::dvec3(1, 2, 2));
  for (int k = 0; k < 3; ++k) EXPECT_EQ(volume.at(2, 1, k), float(70 * k));
  EXPECT_EQ(load_volume(path("set/DICOMDIR")).values, volume.values);
}

/// Two frames of 4x3 pixels, to their pixel data.
std::string two_frames(int samples, const std::string& photometric, int bits) {
  return dicom_head("1.2.840.10008.5.1.4.1.1.7.2", "1.2.3.4") + element(8, 0x60, "CS", "US") +
         element(0x20, 0xd, "UI", "1.2") + element(0x20, 0xe, "UI", "1.2.3") +
         element(0x28, 2, "US", dicom_us(samples)) + element(0x28, 4, "CS", photometric) +
         (samples > 1 ? element(0x28, 6, "US", dicom_us(0)) : "") + element(0x28, 8, "IS", "2") +
         element(0x28, 0x10, "US", dicom_us(3)) + element(0x28, 0x11, "US", dicom_us(4)) +
         element(0x28, 0x100, "US", dicom_us(bits));
}
/// What follows where the pixels are integers.
std::string as_integers(int bits) {
  return element(0x28, 0x101, "US", dicom_us(bits)) + element(0x28, 0x102, "US", dicom_us(bits - 1)) +
         element(0x28, 0x103, "US", dicom_us(0));
}

TEST_F(DicomFrames, MoreThanThereArePixelsOfAreRefused) {
  const std::string head = two_frames(1, "MONOCHROME2", 8) + as_integers(8);
  EXPECT_EQ(load_volume(write("a.dcm", head + element(0x7fe0, 0x10, "OB", std::string(24, 'a')))).values[23],
            97.f);
  for (const int held : {12, 22})
    expect_error(write("b.dcm", head + element(0x7fe0, 0x10, "OB", std::string(std::size_t(held), 'a'))),
                 {"2 frames of 4x3", "24 bytes", fmt::format("has {}", held)});
}

TEST_F(DicomFrames, TwoPixelsMayShareTheirColours) {
  std::string pairs, full;
  for (int i = 0; i < 48; ++i) pairs += char(i);  // luma, luma, and the two differences
  for (int i = 0; i < 72; ++i) full += char(i);
  for (const char* photometric : {"YBR_FULL_422", "YBR_PARTIAL_422 "}) {
    const auto file = [&](int samples, const std::string& pixels, const std::string& more = "") {
      return write("a.dcm", two_frames(samples, photometric, 8) + as_integers(8) + more +
                                element(0x7fe0, 0x10, "OB", pixels));
    };
    for (int component = 0; component < 3; ++component) {
      const Volume volume = load_volume(file(3, pairs) + fmt::format("?component={}", component));
      ASSERT_EQ(volume.values.size(), 24u);
      for (int i = 0; i < 24; ++i) {
        EXPECT_EQ(volume.values[std::size_t(i)], float(i / 2 * 4 + (component > 0 ? 1 + component : i % 2)));
      }
    }
    expect_error(file(3, pairs.substr(0, 46)), {"2 frames of 4x3", "48 bytes", "has 46"});
    expect_error(file(3, full), {"share their colours in 48 bytes", "the 72 bytes of"});
    const Volume one = load_volume(file(1, full.substr(0, 24)));  // has no colours to share
    for (int i = 0; i < 24; ++i) EXPECT_EQ(one.values[std::size_t(i)], float(i));
  }
}

TEST_F(DicomFrames, LumaAndColourDifferencesAreNoColours) {
  const std::string pixels(72, 'a');
  for (const auto& [photometric, said] : {std::pair("RGB", "green"), {"YBR_FULL", "blue less luma"}}) {
    const std::string head = two_frames(3, photometric, 8) + as_integers(8);
    const Volume volume =
        load_volume(write("a.dcm", head + element(0x7fe0, 0x10, "OB", pixels)) + "?component=1");
    EXPECT_NE(volume.note.find(said), std::string::npos) << volume.note;
  }
}

TEST_F(DicomFrames, APalettesNumbersAreKept) {
  std::string table, pixels;
  for (int i = 0; i < 256; ++i) append_value(table, 65535 - 200 * i, uint16, std::endian::little);
  for (int i = 0; i < 24; ++i) pixels += char(10 * i);
  const std::string descriptor = dicom_us(256) + dicom_us(0) + dicom_us(16);
  std::string file = dicom_head("1.2.840.10008.5.1.4.1.1.7.2", "1.2.3.4") + element(8, 0x60, "CS", "US") +
                     element(0x20, 0xd, "UI", "1.2") + element(0x20, 0xe, "UI", "1.2.3") +
                     element(0x28, 2, "US", dicom_us(1)) + element(0x28, 4, "CS", "PALETTE COLOR") +
                     element(0x28, 8, "IS", "2") + element(0x28, 0x10, "US", dicom_us(3)) +
                     element(0x28, 0x11, "US", dicom_us(4)) + element(0x28, 0x100, "US", dicom_us(8)) +
                     element(0x28, 0x101, "US", dicom_us(8)) + element(0x28, 0x102, "US", dicom_us(7)) +
                     element(0x28, 0x103, "US", dicom_us(0));
  for (unsigned color = 0; color < 3; ++color) file += element(0x28, 0x1101 + color, "US", descriptor);
  for (unsigned color = 0; color < 3; ++color) file += element(0x28, 0x1201 + color, "OW", table);
  const Volume volume = load_volume(write("palette.dcm", file + element(0x7fe0, 0x10, "OB", pixels)));
  EXPECT_EQ(volume.file_type, uint8);
  for (int i = 0; i < 24; ++i) EXPECT_EQ(volume.values[std::size_t(i)], float(10 * i));
  EXPECT_NE(volume.note.find("palette"), std::string::npos) << volume.note;
  EXPECT_NE(volume.note.find("slices' distance is not known"), std::string::npos) << volume.note;
}

}  // namespace
}  // namespace crest::test
