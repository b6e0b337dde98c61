#include <gtest/gtest.h>

#include "ui/studio.h"

namespace crest {
namespace {

std::array<int, 4> pixel(const Picture8& picture, int x, int y) {
  const std::size_t i = 4 * std::size_t(y * picture.width + x);
  return {picture.rgba[i], picture.rgba[i + 1], picture.rgba[i + 2], picture.rgba[i + 3]};
}

Peak peak_at(double value, glm::dvec3 color) {
  Peak peak;
  peak.value = value;
  peak.color = color;
  peak.shown = true;
  return peak;
}

TEST(TablePicture, EntryGoesAcrossAndExitUp) {
  const std::vector<Peak> shown{peak_at(2.5, {1, 0, 0}), peak_at(6.5, {0, 1, 0})};
  const PeakTable table = build_peak_table(shown, {0, 8}, 8);
  const Picture8 picture = table_picture(table, shown);
  ASSERT_EQ(picture.width, 8);
  ASSERT_EQ(picture.height, 8);
  ASSERT_EQ(picture.rgba.size(), 256U);
  constexpr std::array<int, 4> red{255, 0, 0, 255}, green{0, 255, 0, 255};
  EXPECT_EQ(pixel(picture, 0, 0), red);    // in at the lowest, out at the highest: red comes first
  EXPECT_EQ(pixel(picture, 7, 7), green);  // and the other way round
  EXPECT_EQ(pixel(picture, 2, 5), red);    // both in the bin of the first peak
  const auto none = pixel(picture, 0, 7);  // both in the lowest bin
  EXPECT_NE(none, red);
  EXPECT_NE(none, green);
  EXPECT_EQ(none[3], 255);
  EXPECT_EQ(pixel(picture, 4, 3), none);  // between the peaks
}

TEST(TablePicture, WithNoPeaksIsOfOneColour) {
  const PeakTable table = build_peak_table({}, {0, 1}, 4);
  const Picture8 picture = table_picture(table, {});
  for (int y = 0; y < 4; ++y)
    for (int x = 0; x < 4; ++x) EXPECT_EQ(pixel(picture, x, y), pixel(picture, 0, 0));
}

}  // namespace
}  // namespace crest
