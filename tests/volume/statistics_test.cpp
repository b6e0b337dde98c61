#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <vector>

#include "render/volume/random.h"
#include "render/volume/volume.h"

namespace crest::test {
namespace {

/// Of values on a grid that is two points wide and high.
VolumeStatistics statistics_of(const std::vector<float>& values, int bins = histogram_bins) {
  const Grid grid{{2, 2, int(values.size()) / 4}, glm::dvec3(1), glm::dvec3(0)};
  EXPECT_EQ(grid.point_count(), values.size());
  return compute_statistics(grid, values, bins);
}

// Regions of one value: in some cells of a row; a value in one slice alone has none; NaN equals nothing.
TEST(Statistics, Plateaus) {
  std::vector<float> values;
  for (const float v : {3.F, 3.F, 3.F, 3.F, 1.F, 1.F, 2.F, NAN, NAN, 3.F, 3.F})
    values.insert(values.end(), 4, v);
  EXPECT_EQ(statistics_of(values).plateaus, (std::vector<float>{1, 3}));
  values[4] = 0;
  EXPECT_EQ(statistics_of(values).plateaus, (std::vector<float>{1, 3}));
  EXPECT_TRUE(statistics_of({1, 2, 3, 4, 5, 6, 7, 8}).plateaus.empty());
}

TEST(Statistics, MayBeOverAWiderRange) {
  Volume volume;
  volume.grid.dims = glm::ivec3(2);
  volume.values = std::vector<float>{1, 2, 3, NAN, 5, 5, 4, 1};
  volume.statistics = compute_statistics(volume.grid, volume.values, 4);
  const Volume before = volume;
  widen_range(volume, {2, 3});
  EXPECT_EQ(volume.statistics.range, (ValueRange{1, 5})) << "never narrower than its values";
  EXPECT_EQ(volume.statistics.histogram, before.statistics.histogram);
  widen_range(volume, {-3, 2});
  EXPECT_EQ(volume.statistics.range, (ValueRange{-3, 5}));
  EXPECT_EQ(volume.statistics.histogram, (std::vector<std::uint64_t>{0, 0, 3, 4}));
  EXPECT_EQ(volume.statistics.mean, before.statistics.mean);
  EXPECT_EQ(volume.values.data(), before.values.data()) << "no voxel is copied";

  volume.values = std::vector<float>(8, NAN);
  volume.statistics = compute_statistics(volume.grid, volume.values, 4);
  EXPECT_FALSE(finite_range(volume));
  widen_range(volume, {2, 3});
  EXPECT_EQ(volume.statistics.range, (ValueRange{2, 3})) << "the 0 of no value is none";
}

TEST(Statistics, OfAFewValues) {
  const auto s = statistics_of({1, 2, 3, NAN, 6, INFINITY, -INFINITY, NAN}, 5);
  EXPECT_EQ(s.range, (ValueRange{1, 6}));
  EXPECT_EQ(s.mean, 3);
  EXPECT_EQ(s.variance, 3.5);
  EXPECT_EQ(s.nan_count, 2u);
  EXPECT_EQ(s.inf_count, 2u);
  EXPECT_EQ(s.histogram,
            (std::vector<std::uint64_t>{1, 1, 1, 0, 1}));  // 6 is in the last bin, which is closed
}

TEST(Statistics, OfNothingFiniteAndOfOneValue) {
  const auto none = statistics_of({NAN, INFINITY, -INFINITY, NAN, NAN, NAN, NAN, NAN}, 3);
  EXPECT_EQ(none.range, (ValueRange{0, 0}));
  EXPECT_EQ(none.mean, 0);
  EXPECT_EQ(none.histogram, (std::vector<std::uint64_t>{0, 0, 0}));
  const auto flat = statistics_of(std::vector<float>(8, 7), 3);
  EXPECT_EQ(flat.variance, 0);
  EXPECT_EQ(flat.histogram, (std::vector<std::uint64_t>{8, 0, 0}));
}

TEST(Statistics, SmallSpreadOnALargeOffsetIsNotLost) {
  std::vector<float> values(3'000'004);
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = 1e7f + float(i % 3);
  const auto s = statistics_of(values);
  EXPECT_NEAR(s.mean - 1e7, 1, 1e-6);
  EXPECT_NEAR(s.variance, 2.0 / 3, 1e-6);
}

TEST(Statistics, AgreeWithLongDoubleAndRepeatExactly) {
  std::vector<float> values(1'234'568);
  Random random(3);
  for (float& v : values) v = float(std::pow(10, random.uniform(-6, 6)) * random.uniform(-1, 1));
  long double sum = 0, squares = 0;
  for (const float v : values) sum += v;
  const long double mean = sum / values.size();
  for (const float v : values) squares += (v - mean) * (v - mean);
  const auto s = statistics_of(values);
  EXPECT_NEAR(s.mean, double(mean), 1e-12 * double(std::sqrt(squares / values.size())));
  EXPECT_NEAR(s.variance / double(squares / values.size()), 1, 1e-13);
  for (int i = 0; i < 5; ++i) {
    const auto again = statistics_of(values);
    EXPECT_EQ(again.mean, s.mean);
    EXPECT_EQ(again.variance, s.variance);
    EXPECT_EQ(again.histogram, s.histogram);
  }
}

TEST(Statistics, HistogramOfARangeCountsItClosed) {
  std::vector<float> values(1000);
  std::iota(values.begin(), values.end(), 0.f);
  EXPECT_EQ(histogram_of(values, {100, 200}, 4), (std::vector<std::uint64_t>{25, 25, 25, 26}));
  EXPECT_EQ(histogram_of(values, {2000, 3000}, 2), (std::vector<std::uint64_t>{0, 0}));
  EXPECT_EQ(histogram_of(std::vector<float>{-3e38f, 3e38f}, {-3.1e38, 3.1e38}, 2),
            (std::vector<std::uint64_t>{1, 1}));
}

}  // namespace
}  // namespace crest::test
