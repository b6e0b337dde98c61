#include <fmt/core.h>

#include <glm/geometric.hpp>

#include "files.h"
#include "presets/error.h"
#include "render/files/load.h"
#include "render/volume/random.h"

namespace crest::test {
namespace {

class DicomTest : public FileTest {
 protected:
  std::vector<std::int16_t> pixels(int slice) const {
    std::vector<std::int16_t> values;
    for (int i = 0; i < 12; ++i) values.push_back(std::int16_t(100 * slice + i - 150));
    return values;
  }
};

TEST_F(DicomTest, SeriesIsSortedByPositionAndScaled) {
  for (int slice = 0; slice < 5; ++slice) {  // the names say the opposite order
    write(fmt::format("series/{}.dcm", 9 - slice),
          dicom_slice(4, 3, -50 + 2.5 * slice, 5 - slice, pixels(slice), slice == 2 ? "2" : "1", "-10"));
  }
  write("series/README.txt", "not DICOM");
  const Volume volume = load_volume(path("series"));
  EXPECT_EQ(volume.grid.dims, glm::ivec3(4, 3, 5));
  EXPECT_EQ(volume.file_type, ScalarType::int16);
  EXPECT_LT(glm::distance(volume.grid.spacing, glm::dvec3(1, 2, 2.5)), 1e-9);
  EXPECT_LT(glm::distance(volume.grid.origin, glm::dvec3(10, 20, -50)), 1e-9);
  for (int k = 0; k < 5; ++k) {
    EXPECT_EQ(volume.at(1, 2, k), float((k == 2 ? 2 : 1) * (100 * k + 9 - 150) - 10)) << k;
  }
}

TEST_F(DicomTest, OneOfSeveralSeriesIsTakenAndSaid) {
  for (int slice = 0; slice < 3; ++slice)
    write(fmt::format("s/a{}.dcm", slice), dicom_slice(4, 3, slice, slice + 1, pixels(slice)));
  for (int slice = 0; slice < 2; ++slice) {
    write(fmt::format("s/b{}.dcm", slice),
          dicom_slice(4, 3, slice, slice + 1, pixels(slice + 7), "1", "0", "1.9.9"));
  }
  const Volume most = load_volume(path("s"));
  EXPECT_EQ(most.grid.dims.z, 3);
  EXPECT_NE(most.note.find("one of 2"), std::string::npos) << most.note;
  const std::string message = error_of(path("s") + "?series=7");
  const std::size_t at = message.find("1.9.9");
  ASSERT_NE(at, std::string::npos) << message;
  const std::string id = message.substr(at, message.find_first_of(", ", at) - at);
  const Volume other = load_volume(path("s") + "?series=" + id);
  EXPECT_EQ(other.grid.dims.z, 2);
  EXPECT_EQ(other.at(0, 0, 0), 550);
}

TEST_F(DicomTest, UnevenSlicesAreSaid) {
  for (int slice = 0; slice < 4; ++slice) {
    write(fmt::format("s/{}.dcm", slice),
          dicom_slice(4, 3, slice == 3 ? 9 : slice, slice + 1, pixels(slice)));
  }
  const Volume volume = load_volume(path("s"));
  EXPECT_NEAR(volume.grid.spacing.z, 3, 1e-9);
  EXPECT_NE(volume.note.find("not evenly spaced"), std::string::npos) << volume.note;
}

TEST_F(DicomTest, BadSeriesAreErrors) {
  write("s/1.dcm", dicom_slice(4, 3, 0, 1, pixels(0)));
  expect_error(path("s"), {"one DICOM slice"});
  expect_error(path("s/1.dcm"), {"one DICOM slice", "folder"});
  write("s/2.dcm", dicom_slice(3, 4, 1, 2, pixels(0)));
  expect_error(path("s"), {path("s")});
  std::string slice = dicom_slice(4, 3, 1, 2, pixels(0));
  for (const std::size_t cut : {std::size_t(1), std::size_t(13), std::size_t(100)}) {
    write("s/2.dcm", slice.substr(0, slice.size() - cut));
    expect_error(path("s"), {path("s")});
  }
  expect_error(path("s") + "?colour=1", {"colour"});
}

/// Without the element of this tag, which must be of a short type.
std::string without(std::string file, unsigned group, unsigned member) {
  const std::string tag{char(group & 0xff), char(group >> 8), char(member & 0xff), char(member >> 8)};
  const std::size_t at = file.find(tag, 132);
  EXPECT_NE(at, std::string::npos);
  return file.erase(at, 8 + std::size_t(static_cast<unsigned char>(file[at + 6])));
}
std::string replaced(std::string file, const std::string& from, const std::string& to) {
  EXPECT_EQ(from.size(), to.size());
  const std::size_t at = file.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return file.replace(at, from.size(), to);
}

TEST_F(DicomTest, AScoutInTheSeriesIsLeftOutAndSaid) {
  for (int slice = 0; slice < 4; ++slice)
    write(fmt::format("s/{}.dcm", slice), dicom_slice(4, 3, 2.5 * slice, slice + 1, pixels(slice)));
  write("s/scout.dcm", replaced(dicom_slice(4, 3, 4, 9, pixels(9)), R"(1\0\0\0\1\0)", R"(0\1\0\0\0\1)"));
  write("s/wide.dcm", dicom_slice(3, 4, 5, 10, pixels(8)));
  const Volume volume = load_volume(path("s"));
  EXPECT_EQ(volume.grid.dims, glm::ivec3(4, 3, 4));
  EXPECT_NEAR(volume.grid.spacing.z, 2.5, 1e-9);
  EXPECT_NE(volume.note.find("left out"), std::string::npos) << volume.note;
}

TEST_F(DicomTest, PlacesThatRepeatAreFrames) {
  for (int i = 0; i < 6; ++i)  // by place, and the times at each
    write(fmt::format("s/{}.dcm", i), dicom_slice(4, 3, i / 2, i + 1, pixels(i)));
  expect_error(path("s"), {"2 frames", "?frame=0"});
  const Volume volume = load_volume(path("s") + "?frame=1");
  EXPECT_EQ(volume.grid.dims, glm::ivec3(4, 3, 3));
  for (int k = 0; k < 3; ++k) EXPECT_EQ(volume.at(0, 0, k), float(100 * (2 * k + 1) - 150)) << k;
  write("s/odd.dcm", dicom_slice(4, 3, 1, 20, pixels(9)));
  expect_error(path("s"), {"7 images at 3 places"});
}

TEST_F(DicomTest, CopiesCountOnce) {
  for (int slice = 0; slice < 3; ++slice)
    for (const char* name : {"a", "b"})
      write(fmt::format("s/{}{}.dcm", name, slice), dicom_slice(4, 3, slice, slice + 1, pixels(slice)));
  const Volume volume = load_volume(path("s"));
  EXPECT_EQ(volume.grid.dims.z, 3);
  EXPECT_NE(volume.note.find("3 copies"), std::string::npos) << volume.note;
}

TEST_F(DicomTest, Monochrome1IsForDisplay) {
  for (int slice = 0; slice < 2; ++slice) {
    write(fmt::format("s/{}.dcm", slice),
          replaced(dicom_slice(4, 3, slice, slice + 1, pixels(slice), "2", "-10"), "MONOCHROME2",
                   "MONOCHROME1"));
  }
  const Volume volume = load_volume(path("s"));
  EXPECT_EQ(volume.at(1, 2, 1), float(2 * (100 + 9 - 150) - 10));
  EXPECT_NE(volume.note.find("MONOCHROME1"), std::string::npos) << volume.note;
}

TEST_F(DicomTest, SlicesOfDifferentTypesHaveTheirOwnValues) {
  const std::vector<std::int16_t> low(12, -100);
  write("s/1.dcm", dicom_slice(4, 3, 0, 1, low));
  write("s/2.dcm", replaced(dicom_slice(4, 3, 1, 2, low), dicom_element(0x28, 0x103, "US", dicom_us(1)),
                            dicom_element(0x28, 0x103, "US", dicom_us(0))));
  const Volume volume = load_volume(path("s"));
  EXPECT_EQ(volume.at(0, 0, 0), -100.f);
  EXPECT_EQ(volume.at(0, 0, 1), 65436.f);
}

TEST_F(DicomTest, WithoutPlacesTheOrderIsSaid) {
  for (int slice = 0; slice < 11; ++slice) {
    const std::string bare = without(dicom_slice(4, 3, 0, 20 - slice, pixels(slice)), 0x20, 0x32);
    write(fmt::format("numbers/i{}.dcm", slice), bare);
    write(fmt::format("names/i{}.dcm", slice), without(bare, 0x20, 0x13));
  }
  const Volume numbers = load_volume(path("numbers")), names = load_volume(path("names"));
  EXPECT_EQ(numbers.at(0, 0, 0), float(100 * 10 - 150));
  EXPECT_NE(numbers.note.find("order of their numbers"), std::string::npos) << numbers.note;
  EXPECT_EQ(names.at(0, 0, 10), float(100 * 10 - 150));
  EXPECT_EQ(names.at(0, 0, 2), float(100 * 2 - 150));
  EXPECT_NE(names.note.find("order of their names"), std::string::npos) << names.note;
  EXPECT_EQ(names.grid.spacing.z, 9);  // the slices' thickness
  EXPECT_NE(names.note.find("thickness"), std::string::npos) << names.note;
}

TEST_F(DicomTest, ATiltIsSaid) {
  for (int slice = 0; slice < 4; ++slice) {
    write(fmt::format("s/{}.dcm", slice),
          replaced(dicom_slice(4, 3, slice, slice + 1, pixels(slice)), fmt::format("10\\20\\{}", slice),
                   fmt::format("10\\2{}\\{}", slice, slice)));
  }
  const Volume volume = load_volume(path("s"));
  EXPECT_NEAR(volume.grid.spacing.z, 1, 1e-9);
  EXPECT_NE(volume.note.find("tilt of 45 degrees"), std::string::npos) << volume.note;
}

/// A slice with a few bytes changed is read or refused; it never ends the program.
TEST_F(DicomTest, DamagedSlicesAreReadOrRefused) {
  const std::string slice = dicom_slice(4, 3, 1, 2, pixels(0));
  write("s/1.dcm", dicom_slice(4, 3, 0, 1, pixels(0)));
  Random random(7);
  const auto below = [&](std::size_t n) { return std::size_t(random.uniform(0, double(n))); };
  for (int round = 0; round < 150; ++round) {
    std::string damaged = slice;
    for (std::size_t i = 0, changes = 1 + below(3); i < changes; ++i) {
      damaged[128 + below(slice.size() - 128)] = char(below(256));
    }
    write("s/2.dcm", damaged);
    try {
      load_volume(path("s"), {.memory = 1u << 24});
    } catch (const Error& error) {
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
    }
  }
}

}  // namespace
}  // namespace crest::test
