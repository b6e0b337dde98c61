#include "render/volume/match_values.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "presets/peaks.h"
#include "render/volume/builtin.h"
#include "render/volume/random.h"
#include "tests/classify/tf_of.h"

namespace crest::test {
namespace {

Volume mapped(Volume volume, const std::function<double(double)>& map) {
  for (float& value : volume.values.floats()) value = float(map(double(value)));
  volume.statistics = compute_statistics(volume.grid, volume.values);
  return volume;
}

double cubic(double v) { return 200 + 7 * v + v * v * v; }
double cubic_slope(double v) { return 7 + 3 * v * v; }

/// What matched_value() states, at v: a bin of each range, and how far the cubic is from a line over the gap
/// between two values. Voxels lie dense between -3 and 3, so that no gap is wider than a few bins there.
double bound(const ValueDistribution& from, const ValueDistribution& to, double v) {
  const double gap = 4 * from.range.width() / 65536;
  return cubic_slope(v) * from.range.width() / 65536 + to.range.width() / 65536 +
         6 * std::abs(v) * gap * gap / 8;
}

TEST(MatchValues, AKnownMonotoneMapIsFound) {
  const Volume volume = make_builtin("noise?n=96");
  const ValueDistribution from = distribution_of(volume), to = distribution_of(mapped(volume, cubic));
  Random random(1);
  for (int i = 0; i < 2000; ++i) {
    const double v = random.uniform(-2.5, 2.5);
    EXPECT_NEAR(matched_value(from, to, v), cubic(v), bound(from, to, v)) << v;
    EXPECT_NEAR(matched_value(to, from, cubic(v)), v, 2 * bound(from, to, v) / cubic_slope(v)) << v;
  }
}

TEST(MatchValues, LabelsGoToLabels) {
  Volume labels = make_builtin("noise?n=16");
  labels = mapped(labels, [](double v) { return std::floor(v); });
  const Volume others = mapped(labels, [](double v) { return std::exp(v); });
  const ValueDistribution from = distribution_of(labels), to = distribution_of(others);
  for (const double label : {-2.0, -1.0, 0.0, 1.0, 2.0})
    EXPECT_NEAR(matched_value(from, to, label), std::exp(label), 2 * to.range.width() / 65536) << label;
}

TEST(MatchValues, IsMonotoneAndGoesOnBeyondTheEnds) {
  const ValueDistribution from = distribution_of(make_builtin("sphere?n=9")),
                          to = distribution_of(make_builtin("noise?n=9"));
  double last = -1e9;
  for (double v = from.range.min - 1; v < from.range.max + 1; v += 0.01) {
    const double now = matched_value(from, to, v);
    EXPECT_GE(now, last);
    last = now;
  }
  const double ratio = to.range.width() / from.range.width();
  EXPECT_NEAR(matched_value(from, to, from.range.max + 0.5), to.range.max + 0.5 * ratio, 1e-9);
}

TEST(MatchValues, NothingFiniteChangesNothing) {
  const ValueDistribution none =
      distribution_of(mapped(make_builtin("sphere?n=4"), [](double) { return NAN; }));
  EXPECT_TRUE(none.value.empty());
  EXPECT_EQ(matched_value(none, distribution_of(make_builtin("sphere?n=4")), 3), 3);
}

TEST(MatchValues, ATransferFunctionKeepsItsSpikesAndSteps) {
  const Volume volume = make_builtin("noise?n=64");
  const ValueDistribution from = distribution_of(volume), to = distribution_of(mapped(volume, cubic));
  TransferFunction tf = tf_of({{-2, 0},
                               {-1.001, 0.1},
                               {-1, 0.7},
                               {-0.999, 0.1},
                               {0.5, 0.2},
                               {0.5, 0.6},
                               {1.5, 0.1},
                               {1.5, 0.9},
                               {1.5, 0.1},
                               {2, 0.3}});
  const TransferFunction result = carried(tf, from, to, CarryBy::histogram);
  for (const std::size_t i : {0U, 2U, 4U, 5U, 6U, 7U, 8U, 9U})
    EXPECT_NEAR(result.points[i].value, cubic(tf.points[i].value), bound(from, to, tf.points[i].value)) << i;
  EXPECT_EQ(result.points[4].value, result.points[5].value);
  EXPECT_EQ(result.points[6].value, result.points[8].value);
  const double ratio = to.range.width() / from.range.width();
  EXPECT_NEAR(result.points[3].value - result.points[1].value, 0.002 * ratio, 1e-9);
  const auto before = find_peaks(tf), after = find_peaks(result);
  ASSERT_EQ(after.size(), before.size());
  for (std::size_t i = 0; i < after.size(); ++i) EXPECT_EQ(after[i].spike, before[i].spike) << i;
  EXPECT_EQ(result.points[2].opacity, 0.7);
}

TEST(MatchValues, BesideASpikeThereMayBeNoRoom) {
  const Volume volume = make_builtin("noise?n=64");
  const ValueDistribution from = distribution_of(volume), to = distribution_of(mapped(volume, [](double v) {
                                                            return std::exp(-2 * v * v * (v < 0 ? 1 : -1));
                                                          }));
  const TransferFunction tf =
      tf_of({{-1.6, 0}, {-1.501, 0.1}, {-1.5, 0.7}, {-1.499, 0.1}, {-1.498, 0.2}, {2, 0}});
  const TransferFunction result = carried(tf, from, to, CarryBy::histogram);
  for (std::size_t i = 1; i < result.points.size(); ++i)
    EXPECT_GE(result.points[i].value, result.points[i - 1].value);
  EXPECT_NEAR(result.points[2].value, matched_value(from, to, -1.5), 1e-12);
  EXPECT_NEAR(result.points[4].value, matched_value(from, to, -1.498), 1e-12);
}

TEST(MatchValues, ByRangeAndByValue) {
  const ValueDistribution from = distribution_of(make_builtin("linear?n=5")),
                          to = distribution_of(make_builtin("linear?n=5&a=2&b=1&c=0.5"));
  const TransferFunction tf = tf_of({{-1, 0.2}, {1.75, 0.4}});
  EXPECT_EQ(carried(tf, from, to, CarryBy::value), tf);
  const TransferFunction result = carried(tf, from, to, CarryBy::range);
  EXPECT_NEAR(result.points[0].value, -2, 1e-12);
  EXPECT_NEAR(result.points[1].value, 3.5, 1e-12);
}

}  // namespace
}  // namespace crest::test
