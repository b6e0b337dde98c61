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
