// How the pixels of a DICOM file are stored.
#include <fmt/core.h>

#include <algorithm>

#include "files.h"
#include "render/files/load.h"

namespace crest::test {
namespace {

using enum ScalarType;
using std::endian;

/// A multi-frame file of 5x3 pixels a frame.
struct Stored {
  int frames = 3, allocated = 16, stored = 16, high = 15;
  bool is_signed = false;
  int samples = 1;
  std::string syntax = "1.2.840.10008.1.2.1", type = "OW", pixels = {};
};
constexpr int columns = 5, rows = 3, per_frame = columns * rows;

/// The same elements with their numbers in the other order, of which each has 2 bytes but `last`.
std::string big_endian_element(unsigned group, unsigned number, const std::string& type,
                               const std::string& value) {
  std::string out;
  append_value(out, group, uint16, endian::big);
  append_value(out, number, uint16, endian::big);
  out += type;
  const bool is_long = type[0] == 'O';
  if (is_long) out += std::string(2, '\0');
  append_value(out, double(value.size()), is_long ? uint32 : uint16, endian::big);
  return out + value;
}

std::string file_of(const Stored& stored) {
  const bool is_big = stored.syntax == "1.2.840.10008.1.2.2";
  const auto element = [&](unsigned group, unsigned number, const std::string& type,
                           const std::string& value) {
    return is_big ? big_endian_element(group, number, type, value)
                  : dicom_element(group, number, type, value);
  };
  const auto us = [&](unsigned number, int value) {
    std::string bytes;
    append_value(bytes, value, uint16, is_big ? endian::big : endian::little);
    return element(0x28, number, "US", bytes);
  };
  std::string head = dicom_head("1.2.840.10008.5.1.4.1.1.7.4", "1.2.3.4", stored.syntax);
  head.resize(head.find(std::string("\x08\x00\x16\x00", 4)));
  return head + element(8, 0x18, "UI", "1.2.3.40") + us(2, stored.samples) +
         element(0x28, 4, "CS", stored.samples == 3 ? "RGB " : "MONOCHROME2 ") +
         (stored.samples > 1 ? us(6, 1) : "") +
         element(0x28, 8, "IS",
                 stored.frames < 10 ? fmt::format("{} ", stored.frames) : fmt::format("{}", stored.frames)) +
         us(0x10, rows) + us(0x11, columns) + us(0x100, stored.allocated) + us(0x101, stored.stored) +
         us(0x102, stored.high) + us(0x103, stored.is_signed) + stored.pixels;
}

std::string plain(const Stored& stored, std::string pixels) {
  if (pixels.size() % 2 != 0) pixels += '\0';
  Stored with = stored;
  with.pixels = stored.syntax == "1.2.840.10008.1.2.2" ? big_endian_element(0x7fe0, 0x10, stored.type, pixels)
                                                       : dicom_element(0x7fe0, 0x10, stored.type, pixels);
  return file_of(with);
}

std::string numbers(int count, ScalarType type, endian order, auto value) {
  std::string bytes;
  for (int i = 0; i < count; ++i) append_value(bytes, value(i), type, order);
  return bytes;
}

void expect_values(const Volume& volume, ScalarType type, auto value) {
  EXPECT_EQ(volume.file_type, type);
  ASSERT_EQ(volume.grid.dims, glm::ivec3(columns, rows, int(volume.values.size()) / per_frame));
  for (int i = 0; i < int(volume.values.size()); ++i)
    ASSERT_EQ(volume.at(i % columns, i / columns % rows, i / per_frame), float(value(i))) << "of pixel " << i;
}

class DicomPixels : public FileTest {};

TEST_F(DicomPixels, SingleBitsFollowEachOtherThroughAllFrames) {
  const auto bit = [](int i) { return i * i % 7 % 2 + (i % 5 == 0) == 1 ? 1 : 0; };
  std::string packed((3 * per_frame + 7) / 8, '\0');
  for (int i = 0; i < 3 * per_frame; ++i) packed[std::size_t(i / 8)] |= char(bit(i) << i % 8);
  const Stored stored{.allocated = 1, .stored = 1, .high = 0, .type = "OB"};
  const std::string file = write("bits.dcm", plain(stored, packed));
  expect_values(load_volume(file), uint8, bit);
  expect_values(load_volume(file + "?crop=:,:,1:3"), uint8, [&](int i) { return bit(i + per_frame); });
  expect_error(write("short.dcm", plain(stored, packed.substr(0, 4))),
               {"3 frames of 5x3", "6 bytes of pixels", "has 4"});
  const Stored two{.allocated = 2, .stored = 2, .high = 1, .type = "OB"};
  expect_error(write("two.dcm", plain(two, std::string(12, 'x'))), {"(0028,0100) is 2, and not 1"});
}

TEST_F(DicomPixels, BitsAboutThoseStoredAreNoPartOfTheValue) {
  struct Case {
    int stored, high;
    bool is_signed;
  };
  for (const Case& c : {Case{12, 15, true},
                        {12, 15, false},
                        {10, 11, true},
                        {10, 11, false},
                        {12, 11, true},
                        {1, 0, false},
                        {16, 15, true}}) {
    const int count = 1 << c.stored, lowest = c.is_signed ? -count / 2 : 0;
    const auto value = [&](int i) { return lowest + i * 8191 % count; };
    const auto bits = [&](int i) {  // others hold an overlay
      const unsigned mask = unsigned(count - 1) << (c.high + 1 - c.stored);
      return double((unsigned(value(i)) << (c.high + 1 - c.stored) & mask) | (i * 40503u & 0xffff & ~mask));
    };
    const Stored stored{.stored = c.stored, .high = c.high, .is_signed = c.is_signed};
    const std::string file =
        write("bits.dcm", plain(stored, numbers(3 * per_frame, uint16, endian::little, bits)));
    expect_values(load_volume(file), c.is_signed ? int16 : uint16, value);
  }
  const Stored below{.stored = 12, .high = 7};
  expect_error(write("below.dcm", plain(below, std::string(90, 'x'))), {"12 that end at bit 7"});
}

TEST_F(DicomPixels, BigEndianOnesByTheirWords) {
  const std::string big = "1.2.840.10008.1.2.2";
  const auto value = [](int i) { return 300 * i - 5000; };
  const Stored words{.is_signed = true, .syntax = big};
  expect_values(load_volume(write("b.dcm", plain(words, numbers(3 * per_frame, int16, endian::big, value)))),
                int16, value);

  const auto small = [](int i) { return 5 * i + 1; };
  const std::string bytes = numbers(3 * per_frame, uint8, endian::big, small) + '\0';
  Stored in_bytes{.allocated = 8, .stored = 8, .high = 7, .syntax = big, .type = "OB"};
  expect_values(load_volume(write("b.dcm", plain(in_bytes, bytes))), uint8, small);
  std::string swapped = bytes;
  for (std::size_t i = 0; i + 1 < swapped.size(); i += 2) std::swap(swapped[i], swapped[i + 1]);
  in_bytes.type = "OW";
  expect_values(load_volume(write("b.dcm", plain(in_bytes, swapped))), uint8, small);
}

TEST_F(DicomPixels, FloatingPointOnesHaveElementsOfTheirOwn) {
  const auto value = [](int i) { return 0.5 * i - 1e6; };
  Stored stored{.allocated = 32, .stored = 32, .high = 31};
  stored.pixels = dicom_element(0x7fe0, 8, "OF", numbers(3 * per_frame, float32, endian::little, value));
  expect_values(load_volume(write("f.dcm", file_of(stored))), float32, value);
  stored.allocated = stored.stored = 16, stored.high = 15;  // it is not asked
  expect_values(load_volume(write("f.dcm", file_of(stored))), float32, value);
  stored.pixels = dicom_element(0x7fe0, 8, "OF", numbers(3 * per_frame - 1, float32, endian::little, value));
  expect_error(write("short.dcm", file_of(stored)), {"3 frames of 5x3", "180 bytes", "has 176"});
  stored.allocated = stored.stored = 64, stored.high = 63;
  stored.pixels = dicom_element(0x7fe0, 9, "OD", numbers(3 * per_frame, float64, endian::little, value));
  expect_values(load_volume(write("d.dcm", file_of(stored))), float64, value);
}

TEST_F(DicomPixels, WhatIsRoundedCountsInAllFrames) {
  const Stored stored{.allocated = 32, .stored = 32, .high = 31};
  const auto value = [](int i) { return double(1 << 24) + i; };
  const std::string file =
      write("large.dcm", plain(stored, numbers(3 * per_frame, uint32, endian::little, value)));
  const std::string note = load_volume(file).note;
  EXPECT_NE(note.find("rounds 22 voxels by up to 1"), std::string::npos) << note;  // the odd ones
  EXPECT_NE(note.find("?subtract=16777216 keeps"), std::string::npos) << note;
  expect_values(load_volume(file + "?subtract=16777216"), uint32, [](int i) { return i; });
}

TEST_F(DicomPixels, PlanesOfSamples) {
  const Stored stored{.allocated = 8, .stored = 8, .high = 7, .samples = 3, .type = "OB"};
  const auto value = [](int i) { return i; };  // frame by frame, the red ones first
  const std::string file =
      write("rgb.dcm", plain(stored, numbers(9 * per_frame, uint8, endian::little, value)));
  expect_values(load_volume(file + "?component=1"), uint8,
                [](int i) { return i / per_frame * 3 * per_frame + per_frame + i % per_frame; });
}

TEST_F(DicomPixels, ADeflatedFileIsRefusedWithTheWayOut) {
  const Stored stored{.syntax = "1.2.840.10008.1.2.1.99"};
  expect_error(write("z.dcm", plain(stored, std::string(90, 'x'))), {"deflated", "dcmconv +te"});
}

/// Annex G of PS3.5: the high bytes, then the low ones, of 15 pixels each, as they are.
std::string run_lengths(int first) {
  std::string high(1, char(per_frame - 1)), low = high;
  for (int i = 0; i < per_frame; ++i) {
    high += char((first + i) * 100 >> 8);
    low += char((first + i) * 100 & 0xff);
  }
  std::string head = bytes_of({2, 64, 64.0 + per_frame + 1}, uint32);
  head.resize(64, '\0');
  return head + high + low;
}

TEST_F(DicomPixels, CompressedFramesAreFragments) {
  constexpr int frames = 4;
  Stored stored{.frames = frames, .syntax = "1.2.840.10008.1.2.5"};
  std::vector<std::string> parts;
  for (int f = 0; f < frames; ++f) parts.push_back(run_lengths(f * per_frame));
  stored.pixels = dicom_fragments(parts);
  const std::string file = write("rle.dcm", file_of(stored));
  expect_values(load_volume(file), uint16, [](int i) { return 100 * i; });
  expect_values(load_volume(file + "?crop=:,:,2:4"), uint16, [](int i) { return 100 * (i + 2 * per_frame); });
  // What pads a file does not count
  expect_values(load_volume(write("padded.dcm", file_of(stored) + std::string(100, '\0'))), uint16,
                [](int i) { return 100 * i; });
}

class RunLengths : public DicomPixels {
 protected:
  /// A file of two frames of that.
  std::string of(const std::string& frame, Stored stored = {}) const {
    stored.syntax = "1.2.840.10008.1.2.5";
    stored.frames = 2;
    stored.pixels = dicom_fragments({even(frame), even(frame)});
    return write("rle.dcm", file_of(stored));
  }
  /// A frame with such segments.
  static std::string with_segments(const std::vector<std::string>& segments) {
    std::string head = bytes_of({double(segments.size())}, uint32), all;
    for (const std::string& segment : segments) {
      head += bytes_of({64.0 + double(all.size())}, uint32);
      all += segment;
    }
    head.resize(64, '\0');
    return head + all;
  }
  static std::string even(std::string bytes) { return bytes.append(bytes.size() % 2, '\0'); }
};

TEST_F(RunLengths, RepeatAndSkipAndArePadded) {
  const std::string high = std::string("\xf2\1", 2), low = std::string("\xf6\2\x80\3abcd\0\x80", 9);
  const std::string file = of(with_segments({high, low}));
  expect_values(load_volume(file), uint16,
                [](int i) { return 256 + (i % per_frame < 11 ? 2 : 'a' + i % per_frame - 11); });
  Stored shifted{.stored = 12, .high = 15};
  expect_values(load_volume(of(with_segments({high, low}), shifted)), uint16,
                [](int i) { return (256 + (i % per_frame < 11 ? 2 : 'a' + i % per_frame - 11)) >> 4; });
}

TEST_F(RunLengths, ThatAreOtherThanTheHeaderSaysAreRefused) {
  const std::string fifteen("\xf2\1", 2), fourteen("\xf3\1", 2), sixteen("\xf1\1", 2);
  expect_error(of(with_segments({fifteen})), {"1 segments of run lengths", "promises 2"});
  expect_error(of(with_segments({fifteen, fifteen, fifteen})), {"3 segments"});
  expect_error(of(with_segments({fifteen, fourteen})), {"after 14 of 15 pixels"});
  expect_error(of(with_segments({fifteen, sixteen})), {"more pixels than the 5x3"});
  expect_error(of(with_segments({fifteen + fifteen, fifteen})), {"more pixels than the 5x3"});
  expect_error(of(with_segments({fifteen, std::string("\7ab", 3)})), {"after 0 of 15"});
  std::string beyond = with_segments({fifteen, fifteen});
  beyond[8] = '\x7f';
  expect_error(of(beyond), {"do not lie in the frame"});
  expect_error(of("short"), {"0 segments"});
}

TEST_F(DicomPixels, WhatStandsInOtherBitsIsSaid) {
  const Stored stored{.allocated = 16, .stored = 12, .high = 11, .is_signed = true};
  const auto note = [&](int sample) {
    const auto value = [&](int i) { return i == 7 ? sample : i; };
    return load_volume(
               write("bits.dcm", plain(stored, numbers(3 * per_frame, uint16, endian::little, value))))
        .note;
  };
  const std::string said = "other bits than the 12 stored ones";
  EXPECT_EQ(note(0x0800).find(said), std::string::npos) << "a sign that is not carried on";
  EXPECT_EQ(note(0xf800).find(said), std::string::npos) << "one that is";
  EXPECT_NE(note(0x1800).find(said), std::string::npos);
}

}  // namespace
}  // namespace crest::test
