#include "ui/edit_points.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/ui/harness.h"

namespace crest {
namespace {

using test::points_of;
using test::tf_of;

bool is_ordered(const TransferFunction& tf) {
  return std::ranges::is_sorted(tf.points, {}, &ControlPoint::value);
}

TEST(InsertPoint, TakesTheCurvesColour) {
  TransferFunction tf = tf_of({{0, 0}, {10, 1}});
  tf.points[0].color = {0, 0, 0};
  const std::size_t i = insert_point(tf, 2.5, 0.6);
  EXPECT_EQ(i, 1U);
  EXPECT_EQ(tf.points[1].value, 2.5);
  EXPECT_EQ(tf.points[1].opacity, 0.6);
  EXPECT_DOUBLE_EQ(tf.points[1].color.r, 0.25);
}

TEST(InsertPoint, IntoAnEmptyOne) {
  TransferFunction tf;
  EXPECT_EQ(insert_point(tf, 3, 2), 0U);
  EXPECT_EQ(tf.points[0].opacity, 1);
}

TEST(InsertPeak, LeavesTheCurveBesideItAlone) {
  TransferFunction tf = tf_of({{0, 0}, {10, 0.5}});
  const TransferFunction before = tf;
  const std::size_t apex = insert_peak(tf, 4, 0.9, 0.001, {1, 0, 0});
  EXPECT_EQ(apex, 2U);
  EXPECT_EQ(tf.points[2].value, 4);
  EXPECT_NEAR(tf.points[3].value - tf.points[1].value, 0.001, 1e-12);
  for (const double value : {1.0, 3.99, 4.01, 9.0})
    EXPECT_NEAR(evaluate(tf, value).opacity, evaluate(before, value).opacity, 1e-12);
  const std::vector<Peak> peaks = find_peaks(tf);
  ASSERT_EQ(peaks.size(), 1U);
  EXPECT_TRUE(peaks[0].spike);
}

TEST(InsertPeak, OfNoWidthIsATrueSpike) {
  TransferFunction tf = tf_of({{0, 0.1}, {10, 0.1}});
  insert_peak(tf, 5, 0.7, 0, {1, 1, 1});
  EXPECT_EQ(tf.points[1].value, tf.points[3].value);
  ASSERT_EQ(find_peaks(tf).size(), 1U);
  EXPECT_EQ(find_peaks(tf)[0].width, 0);
}

TEST(InsertPeak, IsSqueezedBetweenItsNeighbours) {
  TransferFunction tf = tf_of({{0, 0}, {1, 0.1}, {2, 0.1}, {3, 0}});
  insert_peak(tf, 1.5, 0.9, 100, {1, 1, 1});
  EXPECT_TRUE(is_ordered(tf));
  EXPECT_EQ(tf.points.size(), 7U);
}

TEST(InsertPeak, AtAPointThatIsThereIsStillAPeak) {
  TransferFunction tf = tf_of({{0, 0}, {5, 0.2}, {10, 0}});
  insert_peak(tf, 5, 0.9, 0.1, {1, 1, 1});
  ASSERT_EQ(find_peaks(tf).size(), 1U);
  EXPECT_EQ(find_peaks(tf)[0].opacity, 0.9);
}

TEST(WidestGap, IsWhereThereIsMostRoom) {
  EXPECT_EQ(widest_gap(tf_of({{0, 0}, {1, 0}, {4, 0}, {5, 0}}), {0, 5}), 2.5);
  EXPECT_EQ(widest_gap({}, {2, 4}), 3);
}

TEST(InsertStep, JumpsToTheOpacity) {
  TransferFunction tf = tf_of({{0, 0}, {10, 0}});
  insert_step(tf, 4, 0.5);
  EXPECT_EQ(evaluate_left(tf, 4).opacity, 0);
  EXPECT_EQ(evaluate_right(tf, 4).opacity, 0.5);
}

TEST(MakeStep, HoldsTheLeftNeighboursOpacityUpToThePoint) {
  TransferFunction tf = tf_of({{0, 0.1}, {4, 0.8}, {10, 0}});
  EXPECT_EQ(make_step(tf, 1), 2U);
  EXPECT_DOUBLE_EQ(evaluate_left(tf, 4).opacity, 0.1);
  EXPECT_DOUBLE_EQ(evaluate(tf, 2).opacity, 0.1);
  EXPECT_DOUBLE_EQ(evaluate_right(tf, 4).opacity, 0.8);
}

TEST(InDomain, ThereAndBackIsTheSame) {
  TransferFunction tf = tf_of({{0, 0}, {64, 0.5}, {128, 1}});
  const TransferFunction unit = in_domain(tf, Domain::normalized, {0, 128});
  EXPECT_EQ(unit.domain, Domain::normalized);
  EXPECT_EQ(unit.points[1].value, 0.5);
  EXPECT_EQ(in_domain(unit, Domain::data, {0, 128}), tf);
}

TEST(InDomain, AConstantVolumeCountsAsOneWide) {
  const TransferFunction unit = in_domain(tf_of({{7, 0}, {7.5, 1}}), Domain::normalized, {7, 7});
  EXPECT_EQ(unit.points[0].value, 0);
  EXPECT_EQ(unit.points[1].value, 0.5);
}

TEST(ErasePoints, TakesTheSelectedOnly) {
  TransferFunction tf = tf_of({{0, 0}, {1, 1}, {2, 0}, {3, 1}});
  erase_points(tf, {0, 2});
  ASSERT_EQ(tf.points.size(), 2U);
  EXPECT_EQ(tf.points[0].value, 1);
  EXPECT_EQ(tf.points[1].value, 3);
}

}  // namespace
}  // namespace crest
