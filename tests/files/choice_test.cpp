#include <fmt/core.h>

#include "files.h"
#include "render/files/load.h"
#include "render/files/open_choice.h"
#include "render/files/raw_layout.h"
#include "render/files/raw_slice.h"

namespace crest::test {
namespace {

class ChoiceTest : public FileTest {
 protected:
  /// What load_volume wants to know; the default where it wants nothing.
  static OpenChoice choice_of(const std::string& source, bool asks = false) {
    try {
      load_volume(source, {.asks = asks});
    } catch (const ChoiceNeeded& needed) {
      return needed.choice;
    }
    ADD_FAILURE() << source << " needs no choice";
    return {};
  }
};

TEST_F(ChoiceTest, ComponentsAreAskedForThenFrames) {
  const std::string header =
      "NRRD0004\ntype: uint8\ndimension: 5\nsizes: 3 4 5 2 2\nkinds: RGB-color space space space time\n"
      "encoding: raw\n\n";
  const std::string file = write("film.nrrd", header + std::string(240, 'a'));
  const OpenChoice component = choice_of(file);
  EXPECT_EQ(component.kind, ChoiceKind::component);
  EXPECT_EQ(component.count, 3U);
  EXPECT_EQ(component.path, file);
  ASSERT_EQ(component.options.size(), 3U);
  EXPECT_EQ(component.options[1].text, "component 1: green");
  const OpenChoice frame = choice_of(chosen_source(component, 1));
  EXPECT_EQ(frame.kind, ChoiceKind::frame);
  EXPECT_EQ(frame.count, 2U);
  EXPECT_TRUE(frame.options.empty());
  EXPECT_EQ(chosen_source(frame, 1), file + "?component=1&frame=1");
  EXPECT_EQ(load_volume(chosen_source(frame, 1)).grid.dims, glm::ivec3(4, 5, 2));
}

TEST_F(ChoiceTest, ArraysAreAskedForByTheirNames) {
  std::string text =
      "# vtk DataFile Version 3.0\nx\nASCII\nDATASET STRUCTURED_POINTS\nDIMENSIONS 2 2 2\n"
      "POINT_DATA 8\nFIELD fields 2\nheat 1 8 float\n1 2 3 4 5 6 7 8\n"
      "wind 1 8 float\n8 7 6 5 4 3 2 1\n";
  const std::string file = write("v.vtk", text);
  for (const std::string& source : {file, file + "?array=rain"}) {
    const OpenChoice array = choice_of(source);
    EXPECT_EQ(array.kind, ChoiceKind::array);
    EXPECT_EQ(array.options, (std::vector<ChoiceOption>{{"heat", "heat"}, {"wind", "wind"}}));
    EXPECT_EQ(load_volume(chosen_source(array, 1)).values[0], 8.f);
  }
}

TEST_F(ChoiceTest, SeveralSeriesAreAChoiceOnlyWhereAPersonCanBeAsked) {
  const std::vector<std::int16_t> pixels(12, 7);
  for (int slice = 0; slice < 2; ++slice)
    write(fmt::format("s/a{}.dcm", slice), dicom_slice(4, 3, slice, slice + 1, pixels, "1", "0", "1.1.1"));
  for (int slice = 0; slice < 3; ++slice)
    write(fmt::format("s/b{}.dcm", slice), dicom_slice(4, 3, slice, slice + 1, pixels, "1", "0", "1.9.9"));
  EXPECT_EQ(load_volume(path("s")).grid.dims.z, 3);
  const OpenChoice series = choice_of(path("s"), true);
  EXPECT_EQ(series.kind, ChoiceKind::series);
  ASSERT_EQ(series.options.size(), 2U);
  EXPECT_NE(series.options[0].text.find("3 images"), std::string::npos) << series.options[0].text;
  EXPECT_EQ(load_volume(chosen_source(series, 1), {.asks = true}).grid.dims.z, 2);
  EXPECT_EQ(choice_of(path("s") + "?series=7").options, series.options);
}

TEST_F(ChoiceTest, RawVoxelsAreAskedForWithWhatIsKnown) {
  const std::string file = write("v.raw", std::string(60, 'a'));
  EXPECT_EQ(choice_of(file).kind, ChoiceKind::raw_layout);
  EXPECT_EQ(choice_of(write("v.strange", "abc")).kind, ChoiceKind::raw_layout);
  write("v.raw.json", R"({"size": [5, 4, 4], "type": "uint8", "offset": 2})");
  const RawLayout known = layout_of(choice_of(file).query);  // which is too long
  EXPECT_EQ(known.size, glm::ivec3(5, 4, 4));
  EXPECT_EQ(known.offset, 2U);
  RawLayout right = known;
  right.size.z = 3;
  right.offset = 0;
  right.spacing = {1, 2, 0.5};
  // The query must undo what the sidecar says
  const std::string source = source_of(file, query_of(right, choice_of(file).query));
  EXPECT_EQ(source, file + "?offset=0&size=5x4x3&spacing=1,2,0.5&type=uint8");
  EXPECT_EQ(load_volume(source).grid.spacing.z, 0.5);
}

TEST_F(ChoiceTest, TheLengthIsHeldAgainstTheFile) {
  const RawLayout eight{{8, 8, 8}, ScalarType::uint16, false, 0, glm::dvec3(1)};
  const RawFit right = fit_of(eight, 1024);
  EXPECT_TRUE(right.fits);
  EXPECT_EQ(right.text, "8 x 8 x 8 of uint16 are 1,024 bytes; the file has 1,024: it fits");
  const RawFit long_file = fit_of(eight, 1024 + 256);
  EXPECT_FALSE(long_file.fits);
  EXPECT_NE(long_file.text.find("256 too many"), std::string::npos) << long_file.text;
  ASSERT_EQ(long_file.mends.size(), 2U);
  EXPECT_EQ(long_file.mends[0].size, glm::ivec3(8, 8, 10));
  EXPECT_EQ(long_file.mends[1].offset, 256U);
  for (const RawLayout& mend : long_file.mends) EXPECT_TRUE(fit_of(mend, 1280).fits);
  EXPECT_NE(fit_of(eight, 1000).text.find("24 too few"), std::string::npos);
  RawLayout huge = eight;
  huge.size = glm::ivec3(2147483647);
  EXPECT_NE(fit_of(huge, 1000).text.find("cannot be counted"), std::string::npos);
  EXPECT_FALSE(fit_of({}, 1000).fits);
  huge = eight;
  huge.offset = 2000;
  EXPECT_FALSE(fit_of(huge, 1000).fits);
}

TEST_F(ChoiceTest, GuessesComeFromTheNameFirst) {
  const auto first = [](const char* name, std::uint64_t bytes) {
    const auto guesses = likely_layouts(name, bytes);
    if (guesses.empty()) return RawLayout{};
    for (const RawGuess& guess : guesses) EXPECT_TRUE(fit_of(guess.layout, bytes).fits) << guess.why;
    return guesses.front().layout;
  };
  const std::uint64_t points_there = 64 * 32 * 16;
  EXPECT_EQ(first("foot_64x32x16_uint8.raw", points_there).size, glm::ivec3(64, 32, 16));
  EXPECT_EQ(first("foot 64 32 16 short.raw", 2 * points_there).type, ScalarType::int16);
  EXPECT_EQ(first("foot-64x32x16.dat", 4 * points_there).type, ScalarType::float32);
  const RawLayout after_header = first("foot_64x32x16.raw", points_there + 512);
  EXPECT_EQ(after_header.size, glm::ivec3(64, 32, 16));
  EXPECT_EQ(after_header.offset, 512U);
  EXPECT_EQ(first("foot.raw", 100 * 100 * 100).size, glm::ivec3(100));
  EXPECT_EQ(first("foot.raw", 256 * 256 * 113).size, glm::ivec3(256, 256, 113));
  EXPECT_TRUE(likely_layouts("foot.raw", 7919).empty());  // a prime
}

TEST_F(ChoiceTest, TheMiddleSliceIsReadAtItsPlace) {
  for (const auto order : {std::endian::little, std::endian::big}) {
    std::string bytes = "12345";
    for (int i = 0; i < points; ++i) append_value(bytes, i, ScalarType::uint16, order);
    const std::string file = write("v.raw", bytes);
    const RawLayout layout{{5, 4, 3}, ScalarType::uint16, order == std::endian::big, 5, glm::dvec3(1)};
    const RawSlice slice = read_middle_slice(file, layout, 100);
    EXPECT_EQ(slice.size, glm::ivec2(5, 4));
    EXPECT_EQ(slice.range.min, 20);
    EXPECT_EQ(slice.range.max, 39);
    EXPECT_EQ(slice.grey.front(), 0);
    EXPECT_EQ(slice.grey.back(), 255);
    EXPECT_EQ(read_middle_slice(file, layout, 2).size, glm::ivec2(2, 2));
  }
}

TEST_F(ChoiceTest, ASliceBeyondTheEndIsNotThere) {
  const std::string file = write("v.raw", std::string(34, 'x'));
  const RawSlice slice = read_middle_slice(file, {{5, 4, 3}, ScalarType::uint8, false, 0, glm::dvec3(1)}, 9);
  EXPECT_TRUE(slice.is_there[13]);
  EXPECT_FALSE(slice.is_there[14]);
  const RawLayout long_rows{{2147483647, 2, 2}, ScalarType::float64, false, 0, glm::dvec3(1)};
  EXPECT_THROW(read_middle_slice(file, long_rows, 9), Error);
  EXPECT_THROW(read_middle_slice(file, {{0, 4, 3}, ScalarType::uint8, false, 0, glm::dvec3(1)}, 9), Error);
}

}  // namespace
}  // namespace crest::test
