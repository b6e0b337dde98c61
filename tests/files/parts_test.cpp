#include <fmt/core.h>

#include "files.h"
#include "presets/error.h"
#include "render/files/load.h"
#include "render/files/open_choice.h"
#include "render/volume/random.h"

namespace crest::test {
namespace {

/// Values of a grid that takes several slabs to read, each its own: a number of the point.
constexpr glm::ivec3 large{301, 253, 97};
std::int16_t value_at(int i, int j, int k) { return std::int16_t(i * 7 + j * 211 + k * 4099); }

/// Of 16-bit little-endian values, with these axes from the fastest to the slowest.
std::string large_bytes(std::array<int, 3> axes) {
  std::string bytes;
  glm::ivec3 p;
  for (int c = 0; c < large[axes[2]]; ++c)
    for (int b = 0; b < large[axes[1]]; ++b)
      for (int a = 0; a < large[axes[0]]; ++a) {
        p[axes[0]] = a, p[axes[1]] = b, p[axes[2]] = c;
        const std::int16_t value = value_at(p.x, p.y, p.z);
        bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
      }
  return bytes;
}

std::string npy_head(bool fortran) {
  std::string dictionary = fmt::format("{{'descr': '<i2', 'fortran_order': {}, 'shape': ({}, {}, {}), }}",
                                       fortran ? "True" : "False", large.z, large.y, large.x);
  dictionary.resize(118, ' ');
  return std::string("\x93NUMPY\x01\x00\x76\x00", 10) + dictionary;
}

std::string nrrd_head(const char* encoding) {
  return fmt::format("NRRD0004\ntype: int16\ndimension: 3\nsizes: {} {} {}\nendian: little\nencoding: {}\n\n",
                     large.x, large.y, large.z, encoding);
}

class Parts : public FileTest {
 protected:
  static void expect_large(const std::string& file) {
    const Volume whole = load_volume(file);
    ASSERT_EQ(whole.grid.dims, large);
    std::size_t wrong = 0;
    for (int k = 0; k < large.z; ++k)
      for (int j = 0; j < large.y; ++j)
        for (int i = 0; i < large.x; ++i) wrong += whole.at(i, j, k) != value_at(i, j, k);
    EXPECT_EQ(wrong, 0U);
    Random random(3);
    const auto below = [&](int n) { return int(random.uniform(0, double(n))); };
    for (int round = 0; round < 6; ++round) {
      glm::ivec3 first, end, stride;
      for (int axis = 0; axis < 3; ++axis) {
        stride[axis] = 1 + below(4);
        first[axis] = below(large[axis] - 10);
        end[axis] = first[axis] + 6 + below(large[axis] - first[axis] - 6);
      }
      const std::string query = fmt::format("crop={}:{},{}:{},{}:{}&stride={},{},{}", first.x, end.x, first.y,
                                            end.y, first.z, end.z, stride.x, stride.y, stride.z);
      const Volume part = load_volume(file + (file.find('?') == file.npos ? "?" : "&") + query);
      ASSERT_EQ(part.grid.dims, (end - first + stride - 1) / stride) << query;
      for (int k = 0; k < part.grid.dims.z; ++k)
        for (int j = 0; j < part.grid.dims.y; ++j)
          for (int i = 0; i < part.grid.dims.x; ++i) {
            const glm::ivec3 p = first + stride * glm::ivec3(i, j, k);
            wrong += part.at(i, j, k) != value_at(p.x, p.y, p.z);
          }
      EXPECT_EQ(wrong, 0U) << query;
    }
  }
};

TEST_F(Parts, OfSeveralSlabs) {
  const std::string bytes = large_bytes({0, 1, 2});
  expect_large(write("a.nrrd", nrrd_head("raw") + bytes));
  expect_large(write("b.nrrd", nrrd_head("gzip") + gzip(bytes)));
  expect_large(write("c.raw", bytes) + fmt::format("?size={}x{}x{}&type=int16", large.x, large.y, large.z));
  expect_large(write("d.npy", npy_head(false) + bytes));
}

/// Its slabs lie across x.
TEST_F(Parts, OfSeveralSlabsWithXSlowest) {
  expect_large(write("f.npy", npy_head(true) + large_bytes({2, 1, 0})));
}

TEST_F(Parts, OfAComponentAndAFrame) {
  std::string bytes;
  for (int i = 0; i < 3 * 4 * 5 * 6 * 2; ++i) bytes += char(i);
  const std::string file =
      write("film.nrrd",
            "NRRD0004\ntype: uint8\ndimension: 5\nsizes: 3 4 5 6 2\nkinds: RGB-color space space space time\n"
            "encoding: raw\n\n" +
                bytes);
  const Volume part = load_volume(file + "?component=1&frame=1&crop=1:,1:5,2:&stride=2");
  ASSERT_EQ(part.grid.dims, glm::ivec3(2, 2, 2));
  for (int k = 0; k < 2; ++k)
    for (int j = 0; j < 2; ++j)
      for (int i = 0; i < 2; ++i) {
        const int at = 1 + 3 * (1 + 2 * i + 4 * (1 + 2 * j + 5 * (2 + 2 * k + 6)));
        EXPECT_EQ(part.at(i, j, k), float(at % 256)) << i << j << k;
      }
}

TEST_F(Parts, OfADicomSeriesAsItIsStored) {
  std::filesystem::create_directory(path("s"));
  for (int z = 0; z < 6; ++z) {
    std::vector<std::int16_t> pixels;
    for (int i = 0; i < 20; ++i) pixels.push_back(std::int16_t(100 * z + i));
    write(fmt::format("s/{}.dcm", z), dicom_slice(5, 4, 2.0 * z, z, pixels, "2", "-1000"));
  }
  const Volume part = load_volume(path("s") + "?stride=2,1,2");
  ASSERT_EQ(part.grid.dims, glm::ivec3(3, 4, 3));
  EXPECT_EQ(part.grid.spacing.z, 4);
  EXPECT_FALSE(part.values.are_floats());
  EXPECT_EQ(part.values.byte_count(), 36 * sizeof(std::int16_t));
  EXPECT_EQ(part.at(1, 2, 1), 2.F * (200 + 10 + 2) - 1000);
}

TEST_F(Parts, ScalingThatDiffersBetweenDicomSlicesMakesFloats) {
  std::filesystem::create_directory(path("s"));
  const std::vector<std::int16_t> pixels(20, 7);
  for (int z = 0; z < 3; ++z)
    write(fmt::format("s/{}.dcm", z), dicom_slice(5, 4, z, z, pixels, z == 2 ? "3" : "1"));
  const Volume volume = load_volume(path("s"));
  EXPECT_TRUE(volume.values.are_floats());
  EXPECT_EQ(volume.at(0, 0, 1), 7.F);
  EXPECT_EQ(volume.at(0, 0, 2), 21.F);
}

TEST_F(Parts, OfImagesAsTheyAreStored) {
  std::filesystem::create_directory(path("s"));
  for (int z = 0; z < 4; ++z) {
    std::string page = "P5\n5 4\n255\n";
    for (int i = 0; i < 20; ++i) page += char(20 * z + i);
    write(fmt::format("s/{}.pgm", z), page);
  }
  const Volume part = load_volume(path("s") + "?crop=1:,:,1:&subtract=10");
  ASSERT_EQ(part.grid.dims, glm::ivec3(4, 4, 3));
  EXPECT_EQ(part.values.byte_count(), part.values.size());
  EXPECT_EQ(part.at(2, 1, 1), 20 * 2 + 5 + 3 - 10.F);
  EXPECT_EQ(part.grid.origin, glm::dvec3(1, 0, 1));
}

TEST_F(Parts, OfABuiltin) {
  const Volume whole = load_volume("builtin:noise?n=20"),
               part = load_volume("builtin:noise?n=20&crop=3:,:,:&stride=3");
  ASSERT_EQ(part.grid.dims, glm::ivec3(6, 7, 7));
  EXPECT_EQ(part.at(1, 2, 3), whole.at(6, 6, 9));
  EXPECT_EQ(part.grid.box_min().x, whole.grid.origin.x + 3 * whole.grid.spacing.x);
}

TEST_F(Parts, WrongQueriesAreSaid) {
  const std::string file = write("v.raw", std::string(60, 'x')) + "?size=5x4x3&type=uint8";
  expect_error(file + "&crop=0:5,0:4", {"crop=0:5,0:4", "5x4x3"});
  expect_error(file + "&crop=0:6,:,:", {"crop=0:6,:,:", "no box"});
  expect_error(file + "&crop=3:3,:,:", {"no box"});
  expect_error(file + "&crop=-1:3,:,:", {"no box"});
  expect_error(file + "&crop=a:3,:,:", {"no box"});
  expect_error(file + "&crop=4:5,:,:", {"leaves 1 point on axis x"});
  expect_error(file + "&stride=0", {"stride=0", "2,2,1"});
  expect_error(file + "&stride=2,2", {"stride=2,2"});
  expect_error(file + "&stride=", {"stride="});
  expect_error(file + "&stride=99999999999999999999", {"stride=9999"});
  expect_error(file + "&stride=3", {"leaves 1 point on axis z"});
  EXPECT_EQ(load_volume(file + "&stride=3,2,2").grid.dims, glm::ivec3(2, 2, 2));
}

/// The reader's refusal is a choice here too, and the part that it names can be read with that memory.
TEST_F(Parts, WhatIsTooLargeNamesAPartThatFits) {
  const std::string head = "NRRD0004\ntype: uint8\ndimension: 3\nsizes: 400 400 400\nencoding: raw\n\n";
  const std::string file = write("big.nrrd", head);
  std::filesystem::resize_file(file, head.size() + 64'000'000);  // sparse
  constexpr std::uint64_t memory = 20'000'000;
  try {
    load_volume(file, {.memory = memory});
    FAIL();
  } catch (const ChoiceNeeded& needed) {
    EXPECT_EQ(needed.choice.kind, ChoiceKind::part);
    EXPECT_EQ(needed.choice.path, file);
    EXPECT_EQ(needed.choice.memory, memory);
    ASSERT_TRUE(needed.choice.need);
    EXPECT_EQ(needed.choice.need->part, whole_grid({400, 400, 400}));
    EXPECT_EQ(needed.choice.need->bytes_per_point, 1U);
    EXPECT_TRUE(std::string(needed.what()).find("; ?stride=2 would need 16.4 MB") != std::string::npos)
        << needed.what();
  }
  EXPECT_EQ(load_volume(file + "?stride=2", {.memory = memory}).grid.dims, glm::ivec3(200));
  EXPECT_THROW(load_volume("builtin:noise?n=400", {.memory = memory}), ChoiceNeeded);
}

TEST(PartThatFits, IsTheSmallestStride) {
  const MemoryNeed need{whole_grid({1000, 1000, 5}), 2, 100};
  EXPECT_EQ(part_that_fits(need, 10'000'100)->stride, glm::u64vec3(1));
  EXPECT_EQ(part_that_fits(need, 10'000'099)->stride, glm::u64vec3(2));
  EXPECT_EQ(part_that_fits(need, 116)->stride, glm::u64vec3(500, 500, 4));
  EXPECT_FALSE(part_that_fits(need, 115));
  const MemoryNeed huge{whole_grid(glm::u64vec3(2'000'000'000)), 8};
  EXPECT_EQ(bytes_of(huge), std::nullopt);
  EXPECT_EQ(part_that_fits(huge, 64'000'000)->stride, glm::u64vec3(10'000'000));
}

}  // namespace
}  // namespace crest::test
