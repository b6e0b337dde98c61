#include "ui/move_points.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/ui/harness.h"
#include "ui/curve_beneath.h"

namespace crest {
namespace {

using test::points_of;
using test::tf_of;

bool is_ordered(const std::vector<ControlPoint>& points) {
  return std::ranges::is_sorted(points, {}, &ControlPoint::value);
}

TEST(Moved, StopsAtTheNeighboursValue) {
  const TransferFunction tf = tf_of({{0, 0}, {1, 1}, {2, 0}});
  EXPECT_EQ(moved(tf, {1}, 1, 51, Neighbours::stop).points[1].value, 2);
  EXPECT_EQ(moved(tf, {1}, 1, -49, Neighbours::stop).points[1].value, 0);
  EXPECT_EQ(moved(tf, {2}, 2, 52, Neighbours::stop).points[2].value, 52);
}

TEST(Moved, KeepsTheSelectedTogether) {
  const TransferFunction tf = tf_of({{0, 0}, {1, 1}, {1.5, 0.5}, {3, 0}});
  const Moved shifted = moved(tf, {1, 2}, 1, 51, Neighbours::stop);
  EXPECT_EQ(shifted.points[2].value, 3);
  EXPECT_EQ(shifted.points[1].value, 2.5);
  EXPECT_EQ(moved(tf, {0, 1, 2, 3}, 0, 50, Neighbours::stop).points[0].value, 50);
}

TEST(Moved, PassesItsNeighboursAndTellsWhereItIs) {
  const TransferFunction tf = tf_of({{0, 0}, {1, 0.1}, {2, 0.2}, {3, 0.3}});
  const Moved result = moved(tf, {1}, 1, 2.5, Neighbours::free);
  EXPECT_EQ(result.points, points_of({{0, 0}, {2, 0.2}, {2.5, 0.1}, {3, 0.3}}));
  EXPECT_EQ(result.of({1}), Selection{2});
  EXPECT_EQ(result.of({0, 2}), (Selection{0, 1}));
  EXPECT_EQ(moved(tf, {1}, 1, 2, Neighbours::free).points[1].opacity, 0.1) << "at one value the order stays";
}

TEST(Moved, PushesItsNeighboursAhead) {
  const TransferFunction tf = tf_of({{0, 0}, {1, 0.1}, {2, 0.2}, {5, 0.3}});
  EXPECT_EQ(moved(tf, {1}, 1, 3, Neighbours::push).points, points_of({{0, 0}, {3, 0.1}, {3, 0.2}, {5, 0.3}}));
  EXPECT_EQ(moved(tf, {2}, 2, -1, Neighbours::push).points,
            points_of({{-1, 0}, {-1, 0.1}, {-1, 0.2}, {5, 0.3}}));
}

TEST(Moved, PushesSpikesAndStepsAsAWhole) {
  TransferFunction tf =
      tf_of({{0, 0.1}, {10, 0.1}, {20, 0.1}, {20.5, 0.9}, {21, 0.1}, {30, 0.1}, {30, 0.4}, {100, 0.4}});
  tf.spike_width = 0.02;
  const Moved result = moved(tf, {1}, 1, 40, Neighbours::push);
  EXPECT_EQ(
      result.points,
      points_of({{0, 0.1}, {40, 0.1}, {40, 0.1}, {40.5, 0.9}, {41, 0.1}, {41, 0.1}, {41, 0.4}, {100, 0.4}}));
}

// A random walk of moves by each rule keeps the order, the number of points, and (when free) gets to its
// value.
TEST(Moved, KeepsTheOrderWhateverMoves) {
  TransferFunction tf = tf_of({{0, 0}, {1, 0.5}, {1, 0.9}, {1, 0.5}, {2, 0.2}, {3, 0.2}, {3, 0.7}, {4, 0.1}});
  unsigned dice = 1;
  const auto roll = [&](unsigned sides) {
    dice = dice * 1664525u + 1013904223u;
    return (dice >> 8) % sides;
  };
  for (int i = 0; i < 3000; ++i) {
    const std::size_t anchor = roll(8);
    const double to = double(roll(50)) / 10;
    const auto neighbours = Neighbours(roll(3));
    const Selection moving = whole_of(tf, {anchor}, double(roll(3)));
    const Moved result = moved(tf, moving, anchor, to, neighbours);
    ASSERT_TRUE(is_ordered(result.points));
    ASSERT_EQ(result.points.size(), 8U);
    if (neighbours != Neighbours::stop) {
      ASSERT_EQ(result.points[result.now_at[anchor]].value, to);
    }
    tf.points = result.points;
  }
}

TEST(WholeOf, APeakWithItsFlanksAndAStepWithBothPoints) {
  const TransferFunction tf = tf_of({{0, 0}, {2, 0.1}, {3, 0.9}, {4, 0.1}, {6, 0.1}, {6, 0.5}, {9, 0.5}});
  EXPECT_EQ(whole_of(tf, {2}), (Selection{1, 2, 3}));
  EXPECT_EQ(whole_of(tf, {2}, 0.5), Selection{2}) << "a wide one, where only near flanks go along";
  EXPECT_EQ(whole_of(tf, {1}), Selection{1}) << "a foot goes alone";
  EXPECT_EQ(whole_of(tf, {4}), (Selection{4, 5}));
  EXPECT_EQ(whole_of(tf, {5}), (Selection{4, 5}));
}

// A peak narrower than a handle moves as a whole, and keeps its width to the last digits.
TEST(Moved, ANarrowPeakGoesWithItsFlanks) {
  TransferFunction tf = tf_of({{0.0, 0.0}, {0.1 - 5e-5, 0.1}, {0.1, 0.9}, {0.1 + 5e-5, 0.1}, {1.0, 0.0}});
  const Selection moving = whole_of(tf, {2}, 0.01);
  EXPECT_EQ(moving, (Selection{1, 2, 3}));
  tf.points = moved(tf, moving, 2, 0.4, Neighbours::free).points;
  EXPECT_EQ(tf.points[2].value, 0.4);
  EXPECT_NEAR(tf.points[3].value - tf.points[1].value, 1e-4, 1e-15);
  ASSERT_EQ(find_peaks(tf).size(), 1u);
  EXPECT_TRUE(find_peaks(tf)[0].spike);
}

TEST(Moved, FeetKeepToTheCurveBeneath) {
  TransferFunction tf = tf_of({{0, 0}, {10, 1}});
  tf.points[0].color = {0, 0, 0};
  const TransferFunction ramp = tf;
  const std::size_t apex = insert_peak(tf, 3, 0.9, 0.1, {1, 0, 0});
  tf.points = moved(tf, whole_of(tf, {apex}), apex, 7, Neighbours::free).points;
  ASSERT_EQ(tf.points.size(), 5U);
  EXPECT_EQ(tf.points[2].value, 7);
  EXPECT_EQ(tf.points[2].opacity, 0.9);
  for (const double value : {1.0, 3.0, 6.95, 7.05, 9.0}) {
    EXPECT_NEAR(evaluate(tf, value).opacity, evaluate(ramp, value).opacity, 1e-12) << value;
    EXPECT_NEAR(evaluate(tf, value).color.g, evaluate(ramp, value).color.g, 1e-12) << value;
  }
}

TEST(KeepFeetOnCurve, GoWithTheCurveUnlessTheyAreEdited) {
  TransferFunction tf = tf_of({{0, 0}, {10, 1}});
  const std::size_t apex = insert_peak(tf, 5, 0.9, 0.1, {1, 1, 1});
  TransferFunction before = tf;
  tf.points.back().opacity = 0.2;
  keep_feet_on_curve(tf, before);
  EXPECT_NEAR(tf.points[apex - 1].opacity, 0.2 * 0.495, 1e-12);
  EXPECT_NEAR(tf.points[apex + 1].opacity, 0.2 * 0.505, 1e-12);
  EXPECT_EQ(tf.points[apex].opacity, 0.9);
  before = tf;
  tf.points[apex - 1].opacity = 0.5;
  keep_feet_on_curve(tf, before);
  EXPECT_EQ(tf.points[apex - 1].opacity, 0.5);
}

TEST(Moved, AStepThatRisesFromTheCurveStillDoes) {
  TransferFunction tf = tf_of({{0, 0}, {100, 0.5}});
  const std::size_t upper = insert_step(tf, 80, 0.9);
  tf.points = moved(tf, whole_of(tf, {upper}), upper, 50, Neighbours::free).points;
  EXPECT_EQ(tf.points, points_of({{0, 0}, {50, 0.25}, {50, 0.9}, {100, 0.5}}));
  const TransferFunction plain = tf_of({{0, 0}, {50, 0}, {50, 0.5}, {100, 0.5}});
  EXPECT_EQ(moved(plain, {1, 2}, 1, 30, Neighbours::free).points,
            points_of({{0, 0}, {30, 0}, {30, 0.5}, {100, 0.5}}));
}

TEST(Moved, ValuesOfFewDigitsStaySo) {
  const TransferFunction tf = tf_of({{0, 0}, {0.1, 0}, {0.2, 1}, {0.3, 0}, {1, 0}});
  const Moved result = moved(tf, {1, 2, 3}, 2, 0.9, Neighbours::free);
  EXPECT_EQ(result.points[1].value, 0.8);
  EXPECT_EQ(result.points[3].value, 1.0);
}

TEST(SetPeakWidth, MovesTheFlanksInProportion) {
  TransferFunction tf = tf_of({{0, 0}, {4, 0}, {5, 0.9}, {7, 0}, {10, 0}});
  const std::vector<Peak> peaks = find_peaks(tf);
  ASSERT_EQ(peaks.size(), 1U);
  set_peak_width(tf, peaks[0], 0.3);
  EXPECT_EQ(tf.points[1].value, 4.9);
  EXPECT_EQ(tf.points[2].value, 5);
  EXPECT_EQ(tf.points[3].value, 5.2);
  EXPECT_EQ(peak_width(tf, find_peaks(tf)[0]), 0.3) << "as typed, not 0.2999999999999998";
  set_peak_width(tf, find_peaks(tf)[0], 1000);
  EXPECT_TRUE(is_ordered(tf.points));
}

TEST(SetPeakWidth, LeavesTheCurveBeneath) {
  TransferFunction tf = tf_of({{0, 0}, {10, 1}});
  const std::size_t apex = insert_peak(tf, 4, 0.9, 2, {1, 1, 1});
  const std::vector<Peak> peaks = find_peaks(tf);
  ASSERT_EQ(peaks.at(0).first_point, apex);
  set_peak_width(tf, peaks[0], 0.5);
  for (const double value : {1.0, 3.0, 3.75, 4.25, 4.9})
    EXPECT_NEAR(evaluate(tf, value).opacity, value / 10, 1e-12);
}

TEST(SetPeakWidth, OpensASpikeOfNoWidth) {
  TransferFunction tf = tf_of({{0, 0}, {5, 0}, {5, 0.9}, {5, 0}, {10, 0}});
  set_peak_width(tf, find_peaks(tf).at(0), 0.5);
  EXPECT_EQ(tf.points[1].value, 4.75);
  EXPECT_EQ(tf.points[3].value, 5.25);
}

}  // namespace
}  // namespace crest
