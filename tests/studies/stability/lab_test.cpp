#include "render/studies/stability/lab.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "render/studies/stability/scenes.h"

// The measures must not overlook what they are there to find.
namespace crest::stability {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();

Image picture() { return {{2, 2}, std::vector<glm::vec4>(4, glm::vec4(0.25F))}; }

std::vector<glm::dvec4> truth() { return std::vector<glm::dvec4>(4, glm::dvec4(0.25)); }

TEST(StabilityLab, TheLargestDifferenceOfAnyChannel) {
  EXPECT_EQ(largest_difference(picture(), picture()), 0);
  EXPECT_EQ(largest_difference(picture(), truth()), 0);
  for (std::size_t pixel = 0; pixel < 4; ++pixel)
    for (int channel = 0; channel < 4; ++channel) {
      Image off = picture();
      off.pixels[pixel][channel] += 0.125F;
      EXPECT_EQ(largest_difference(picture(), off), 0.125);
      EXPECT_EQ(largest_difference(off, truth()), 0.125);
      EXPECT_EQ(largest_relative_difference(off, truth()), 0.5);
      off.pixels[pixel][channel] = nan;
      EXPECT_EQ(largest_difference(picture(), off), INFINITY);
      EXPECT_EQ(largest_difference(off, picture()), INFINITY);
      EXPECT_EQ(largest_difference(off, truth()), INFINITY);
      EXPECT_EQ(largest_relative_difference(off, truth()), INFINITY);
    }
}

TEST(StabilityLab, WhatIsLeftOutIsNotCompared) {
  Image off = picture();
  off.pixels[2].g = nan;
  EXPECT_EQ(largest_difference(picture(), off, {false, false, true, false}), 0);
  EXPECT_EQ(largest_difference(picture(), off, {true, true, false, true}), INFINITY);
}

TEST(StabilityLab, ARelativeDifferenceOfNothingHasAFloor) {
  Image faint = picture();
  for (auto& pixel : faint.pixels) pixel = glm::vec4(1e-7F);
  const std::vector<glm::dvec4> zero(4, glm::dvec4(0));
  EXPECT_NEAR(largest_relative_difference(faint, zero, 1e-6), 0.1, 1e-6);
  EXPECT_GT(largest_relative_difference(faint, zero), 1e20);
}

TEST(StabilityLab, EqualIsBitForBit) {
  Image other = picture();
  EXPECT_EQ(unequal_pixels(picture(), other), 0);
  other.pixels[1].b = std::nextafter(0.25F, 1.0F);
  other.pixels[3].a = nan;
  EXPECT_EQ(unequal_pixels(picture(), other), 2);
  EXPECT_EQ(unequal_pixels(other, other), 0);
  Image zero = picture(), minus_zero = picture();
  zero.pixels[0].r = 0;
  minus_zero.pixels[0].r = -0.0F;
  EXPECT_EQ(unequal_pixels(zero, minus_zero), 1);
}

// What is known of a volume decides which shader draws it: a table of another shader than people get says
// nothing.
TEST(StabilityScenes, HaveTheStatisticsOfTheirGrids) {
  const VolumePtr ramp = make_volume(cube(9), [](glm::dvec3 p) { return p.x + 2 * p.y + 4 * p.z; });
  EXPECT_EQ(ramp->statistics.range, (ValueRange{0, 56}));
  EXPECT_EQ(ramp->statistics.largest_difference, glm::dvec3(1, 2, 4));
  const VolumePtr gyroid = gyroid_in_levels();
  EXPECT_EQ(gyroid->statistics.largest_difference,
            compute_statistics(gyroid->grid, gyroid->values).largest_difference);
}

}  // namespace
}  // namespace crest::stability
