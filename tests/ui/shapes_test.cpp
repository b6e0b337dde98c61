#include "ui/shapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "presets/number_text.h"
#include "tests/ui/harness.h"
#include "ui/arrange_points.h"
#include "ui/snap.h"

namespace crest {
namespace {

using test::points_of;
using test::tf_of;

TEST(Shapes, StandOnTheCurveAndLeaveTheRest) {
  const TransferFunction ramp = tf_of({{0, 0}, {100, 0.5}});
  for (const Shape shape : {Shape::spike, Shape::tent, Shape::box, Shape::gaussian}) {
    TransferFunction tf = ramp;
    insert_shape(tf, shape, 40, 0.9, 10, {1, 0, 0});
    EXPECT_EQ(evaluate_left(tf, 40).opacity, 0.9) << label_of(shape);
    for (const double value : {10.0, 34.9, 45.1, 90.0})
      EXPECT_NEAR(evaluate(tf, value).opacity, value / 200, 1e-12) << label_of(shape) << " at " << value;
    EXPECT_TRUE(std::ranges::is_sorted(tf.points, {}, &ControlPoint::value));
  }
}

TEST(Shapes, ABoxIsFlatBetweenItsSteps) {
  TransferFunction tf = tf_of({{0, 0.1}, {38, 0.3}, {100, 0.1}});
  const Selection all = insert_shape(tf, Shape::box, 40, 0.9, 10, {1, 0, 0});
  EXPECT_EQ(all.size(), 4U);
  EXPECT_LT(evaluate_left(tf, 35).opacity, 0.4);
  for (const double value : {35.0, 38.0, 44.9}) EXPECT_EQ(evaluate(tf, value).opacity, 0.9);
  EXPECT_LT(evaluate_right(tf, 45).opacity, 0.4);
}

TEST(Shapes, AGaussianIsWithinItsError) {
  TransferFunction tf = tf_of({{-10, 0}, {10, 0}});
  const Selection all = insert_shape(tf, Shape::gaussian, 0, 1, 7, {1, 1, 1});  // of deviation 1
  EXPECT_LE(all.size(), 15U) << "few points";
  double most = 0;
  for (double x = -5; x <= 5; x += 0.001)
    most = std::max(most, std::abs(evaluate(tf, x).opacity - std::exp(-x * x / 2)));
  EXPECT_LE(most, gaussian_error * 1.05);
  EXPECT_GT(most, gaussian_error * 0.5) << "no more points than that takes";
}

TEST(Shapes, AGaussianMovesAndNarrowsAsAWhole) {
  TransferFunction tf = tf_of({{0, 0}, {100, 0.5}});
  const Selection all = insert_shape(tf, Shape::gaussian, 30, 0.9, 7, {1, 1, 1});
  const std::vector<Peak> peaks = find_peaks(tf);
  ASSERT_EQ(peaks.size(), 1U);
  const std::size_t apex = peaks[0].first_point;
  EXPECT_EQ(whole_of(tf, {apex}), all);
  EXPECT_NEAR(peak_width(tf, peaks[0]), 7, 1e-12);
  tf.points = moved(tf, whole_of(tf, {apex}), apex, 60, Neighbours::free).points;
  for (const double value : {30.0, 56.4, 63.6}) EXPECT_NEAR(evaluate(tf, value).opacity, value / 200, 1e-9);
  set_peak_width(tf, find_peaks(tf)[0], 3.5);
  EXPECT_NEAR(evaluate(tf, 58.2).opacity, 58.2 / 200, 1e-9);
}

TEST(OpacityShapes, LeaveColoursAlone) {
  TransferFunction tf = tf_of({{0, 0.3}, {40, 0.7}, {100, 0.5}});
  tf.points[0].color = {1, 0, 0};
  for (const OpacityShape shape : {OpacityShape::flat, OpacityShape::ramp_up, OpacityShape::ramp_down,
                                   OpacityShape::tent, OpacityShape::gaussian}) {
    const TransferFunction shaped = with_opacities(tf, shape, 0.8);
    for (const double value : {0.0, 10.0, 40.0, 50.0, 73.0, 100.0})
      EXPECT_LT(glm::length(evaluate(shaped, value).color - evaluate(tf, value).color), 1e-12);
  }
  EXPECT_DOUBLE_EQ(evaluate(with_opacities(tf, OpacityShape::ramp_up, 0.8), 25).opacity, 0.2);
  EXPECT_DOUBLE_EQ(evaluate(with_opacities(tf, OpacityShape::tent, 0.8), 50).opacity, 0.8);
  EXPECT_EQ(evaluate(with_opacities(tf, OpacityShape::gaussian, 0.8), 100).opacity, 0);
}

TEST(Arrange, StretchesAndMirrors) {
  const TransferFunction tf = tf_of({{0, 0}, {10, 0.1}, {10, 0.6}, {20, 0.2}, {50, 0}});
  EXPECT_EQ(stretched(tf, {1, 2, 3}, {10, 20}, {10, 40}).points,
            points_of({{0, 0}, {10, 0.1}, {10, 0.6}, {40, 0.2}, {50, 0}}));
  EXPECT_EQ(mirrored(tf, {1, 2, 3}).points, points_of({{0, 0}, {10, 0.2}, {20, 0.6}, {20, 0.1}, {50, 0}}))
      << "a step up becomes one down";
  EXPECT_EQ(mirrored({.points = mirrored(tf, everything(tf)).points, .unknown = {}}, everything(tf)).points,
            tf.points);
}

TEST(Arrange, AlignsAndDistributes) {
  TransferFunction tf = tf_of({{0, 0.2}, {1, 0.4}, {5, 0.9}, {8, 0}});
  EXPECT_EQ(with_values_distributed(tf, everything(tf)).points[1].value, without_noise(8.0 / 3, 8));
  EXPECT_EQ(with_values_aligned(tf, {0, 2}, Alignment::mean).points,
            points_of({{1, 0.4}, {2.5, 0.2}, {2.5, 0.9}, {8, 0}}));
  interpolate_opacities(tf, {0, 1, 3});
  EXPECT_EQ(tf.points[1].opacity, 0.175);
  align_opacities(tf, {0, 2}, Alignment::greatest);
  EXPECT_EQ(tf.points[0].opacity, 0.9);
}

TEST(Arrange, ScalesOpacitiesAndKeepsZeros) {
  TransferFunction tf = tf_of({{0, 0}, {1, 0.1}, {2, 0.8}});
  tf.points[1].surface.opacity = 0.5;
  scale_opacities(tf, everything(tf), 1.5);
  EXPECT_EQ(tf.points[0].opacity, 0);
  EXPECT_EQ(tf.points[1].opacity, 0.15);
  EXPECT_EQ(tf.points[1].surface.opacity, 0.75);
  EXPECT_EQ(tf.points[2].opacity, 1);
}

TEST(Snap, FindsTheHistogramsMaximaAndNotItsNoise) {
  VolumeStatistics statistics;
  statistics.range = {0, 1024};
  statistics.histogram.resize(1024);
  for (std::size_t i = 0; i < 1024; ++i) {
    const double x = double(i);
    const double bumps =
        5000 * std::exp(-std::pow((x - 200) / 30, 2)) + 900 * std::exp(-std::pow((x - 700) / 20, 2));
    statistics.histogram[i] = std::uint64_t(bumps) + 20 + i * 7919 % 13;
  }
  const std::vector<double> maxima = histogram_maxima(statistics);
  ASSERT_EQ(maxima.size(), 2U);
  EXPECT_NEAR(maxima[0], 200, 4);
  EXPECT_NEAR(maxima[1], 700, 4);
}

}  // namespace
}  // namespace crest
