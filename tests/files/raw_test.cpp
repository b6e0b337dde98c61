#include <fmt/core.h>

#include <cmath>

#include "files.h"
#include "render/files/load.h"
#include "render/files/open_choice.h"

namespace crest::test {
namespace {

using enum ScalarType;
using std::endian;

class RawTest : public FileTest {};

TEST_F(RawTest, QueryIsReadInEveryTypeAndByteOrder) {
  for (const ScalarType type : {uint8, int8, uint16, int16, uint32, int32, uint64, int64, float32, float64}) {
    for (const endian order : {endian::little, endian::big}) {
      const std::string file = write("v.raw", "12345" + voxel_bytes(type, order));
      const Volume volume =
          load_volume(fmt::format("{}?size=5x4x3&type={}&offset=5&spacing=1,2,2.5&origin=-1,0,7e-1&endian={}",
                                  file, name_of(type), order == endian::big ? "big" : "little"));
      EXPECT_EQ(volume.file_type, type);
      EXPECT_EQ(volume.grid, (Grid{{5, 4, 3}, {1, 2, 2.5}, {-1, 0, 0.7}}));
      for (int i = 0; i < points; ++i) {
        ASSERT_EQ(volume.values[std::size_t(i)], float(stored_value(type, i))) << name_of(type) << i;
      }
    }
  }
}

TEST_F(RawTest, SidecarAndNameAreUnderstoodAndTheQueryWins) {
  const std::string voxels = voxel_bytes(uint16, endian::big);
  const std::string file = write("scan.raw", voxels);
  write("scan.raw.json",
        R"({"size": [5, 4, 3], "type": "uint16", "endian": "big", "spacing": [1, 1, 0.25]})");
  EXPECT_EQ(load_volume(file).values[1], float(stored_value(uint16, 1)));
  EXPECT_EQ(load_volume(file).grid.spacing.z, 0.25);
  EXPECT_EQ(load_volume(file + "?spacing=1,1,4").grid.spacing.z, 4);

  const std::string named = write("scan_5x4x3_uint16.raw", voxels);
  EXPECT_EQ(load_volume(named + "?endian=big").values, load_volume(file).values);
  EXPECT_EQ(load_volume(write("UPPER_5x4x3_uint8.RAW", std::string(60, 'a'))).values[0], 'a');
  EXPECT_EQ(load_volume(write("no extension", std::string(60, 'b')) + "?size=5x4x3&type=uint8").values[59],
            'b');
}

TEST_F(RawTest, ByteCountMustAgreeExactly) {
  for (const std::size_t count : {59u, 61u, 0u}) {
    expect_error(write("v.raw", std::string(count, 'x')) + "?size=5x4x3&type=uint8",
                 {path("v.raw"), "60 bytes", fmt::format("holds {}", count)});
  }
}

TEST_F(RawTest, ReadingCanBeStopped) {
  std::stop_source stop;
  stop.request_stop();
  Reading reading;
  reading.stop = stop.get_token();
  const std::string file = write("v.raw", std::string(60, 'a'));
  try {
    load_volume(file + "?size=5x4x3&type=uint8", reading);
    ADD_FAILURE() << "it was read";
  } catch (const std::exception& error) {
    EXPECT_EQ(std::string(error.what()), file + ": reading it was stopped");
  }
}

TEST_F(RawTest, WrongQueriesAreSaid) {
  const std::string file = write("v.raw", std::string(60, 'x'));
  expect_error(file, {"unknown size", "?size="});
  expect_error(file + "?size=5x4x3", {"unknown type"});
  expect_error(file + "?size=5x4&type=uint8", {"size=5x4"});
  expect_error(file + "?size=5x4x3&type=uint9", {"uint9", "float64"});
  expect_error(file + "?size=60x1x1&type=uint8", {"axis 2 has 1 points"});
  expect_error(file + "?size=0x4x3&type=uint8", {"axis 1 has 0 points"});
  expect_error(file + "?size=4294967296x4294967296x4294967296&type=uint8", {"4294967296"});
  expect_error(file + "?size=2147483647x2147483647x2147483647&type=float64", {"more than any memory"});
  expect_error(file + "?size=99999999999999999999x2x2&type=uint8", {"size=9999"});
  expect_error(file + "?size=5x4x3&type=uint8&offset=-1", {"offset=-1"});
  expect_error(file + "?size=5x4x3&type=uint8&endian=middle", {"endian=middle"});
  expect_error(file + "?size=5x4x3&type=uint8&spacing=1,2", {"spacing=1,2"});
  expect_error(file + "?size=5x4x3&type=uint8&spacing=nan,1,1", {"spacing=nan"});
  expect_error(file + "?size=5x4x3&type=uint8&colour=red", {"colour", "spacing"});
  expect_error(file + "?size=5x4x3&size=5x4x3", {"twice"});
  expect_error(file + "?size", {"key=value"});
  write("v.raw.json", "[1, 2");
  expect_error(file, {"v.raw.json", "JSON"});
}

TEST_F(RawTest, MoreThanTheMemoryIsRefusedWithBothSizes) {
  const std::string file = write("big.raw", "");
  std::filesystem::resize_file(file, 1000u * 1000 * 1000);  // sparse
  try {
    load_volume(file + "?size=1000x1000x1000&type=uint8", {.memory = 500'000'000});
    FAIL();
  } catch (const ChoiceNeeded& needed) {
    const std::string text = needed.what();
    EXPECT_TRUE(
        text.ends_with("1000x1000x1000 points need 1 GB of memory, and 500 MB are free; ?stride=2 would "
                       "need 125 MB"))
        << text;
    EXPECT_EQ(needed.choice.kind, ChoiceKind::part);
  }
}

TEST_F(RawTest, NegativeAndZeroSpacingAreRepaired) {
  const std::string file = write("v.raw", std::string(60, 'x')) + "?size=5x4x3&type=uint8";
  const Volume volume = load_volume(file + "&spacing=-2,0,3");
  EXPECT_EQ(volume.grid.spacing, glm::dvec3(2, 1, 3));
  EXPECT_NE(volume.note.find("spacing 0 on axis 2"), std::string::npos) << volume.note;
}

TEST_F(RawTest, NanAndInfAreCounted) {
  std::string bytes;
  for (int i = 0; i < 27; ++i) {
    const double value = i == 3 || i == 4 ? std::nan("") : i == 9 ? INFINITY : i == 10 ? 1e300 : i;
    append_value(bytes, value, float64, endian::little);
  }
  const Volume volume = load_volume(write("v_3x3x3_float64.raw", bytes));
  EXPECT_EQ(volume.statistics.nan_count, 2u);
  EXPECT_EQ(volume.statistics.inf_count, 2u);  // 1e300 has no float32
  EXPECT_EQ(volume.statistics.range, (ValueRange{0, 26}));
  EXPECT_TRUE(volume.has_empty_cells());
}

}  // namespace
}  // namespace crest::test
