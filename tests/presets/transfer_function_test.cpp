#include "presets/transfer_function.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace crest {
namespace {

ControlPoint point(double value, double opacity, glm::dvec3 color = glm::dvec3(1)) {
  ControlPoint p;
  p.value = value;
  p.opacity = opacity;
  p.color = color;
  return p;
}

TransferFunction tf_of(std::vector<ControlPoint> points) {
  TransferFunction tf;
  tf.points = std::move(points);
  return tf;
}

TEST(Evaluate, IsLinearBetweenAndConstantBeyond) {
  const TransferFunction tf = tf_of({point(1, 0.25, {0, 0, 1}), point(3, 0.75, {1, 0.5, 0})});
  EXPECT_EQ(evaluate(tf, 2).opacity, 0.5);
  EXPECT_EQ(evaluate(tf, 2).color, glm::dvec3(0.5, 0.25, 0.5));
  for (const double below : {-1e308, 0.0, 1.0}) EXPECT_EQ(evaluate(tf, below).opacity, 0.25);
  for (const double above : {3.0, 4.0, std::numeric_limits<double>::infinity()})
    EXPECT_EQ(evaluate(tf, above).opacity, 0.75);
}

TEST(Evaluate, AtASharedValueTheLastPointHolds) {
  const TransferFunction tf = tf_of({point(0, 0), point(1, 0.2), point(1, 0.9), point(1, 0.4), point(2, 0)});
  EXPECT_EQ(evaluate(tf, 1).opacity, 0.4);
  EXPECT_EQ(evaluate_left(tf, 1).opacity, 0.2);
  EXPECT_EQ(evaluate_right(tf, 1).opacity, 0.4);
  EXPECT_NEAR(evaluate(tf, std::nextafter(1.0, 0.0)).opacity, 0.2, 1e-15);
  const TransferFunction step = tf_of({point(1, 0.2), point(1, 0.9)});
  EXPECT_EQ(evaluate(step, 0).opacity, 0.2);
  EXPECT_EQ(evaluate_left(step, 1).opacity, 0.2);
  EXPECT_EQ(evaluate(step, 1).opacity, 0.9);
}

TEST(Evaluate, ShowsNothingOfNaNOrWithoutPoints) {
  EXPECT_EQ(evaluate(TransferFunction{}, 0.5).opacity, 0);
  const TransferFunction tf = tf_of({point(0, 0.5)});
  for (const auto& limit : {evaluate, evaluate_left, evaluate_right}) {
    EXPECT_EQ(limit(tf, std::nan("")).opacity, 0);
    EXPECT_EQ(limit(tf, 7).opacity, 0.5);
  }
}

TEST(Evaluate, KeepsRelativeAccuracyAtExtremeScales) {
  for (const double scale : {1e-30, 1.0, 1e30}) {
    const TransferFunction tf = tf_of({point(0, 0), point(scale, 0.8), point(3 * scale, 0)});
    for (const double t : {1e-12, 0.1, 0.5, 0.9}) {
      EXPECT_NEAR(evaluate(tf, t * scale).opacity / (0.8 * t), 1, 1e-15);
      EXPECT_NEAR(evaluate(tf, (1 + 2 * t) * scale).opacity / (0.8 * (1 - t)), 1, 4e-15);
    }
    // Just before the foot, where 0.8 - t*0.8 would cancel.
    const double near_foot = std::nextafter(3 * scale, 0.0);
    EXPECT_NEAR(evaluate(tf, near_foot).opacity / (0.4 * (3 * scale - near_foot) / scale), 1, 1e-12);
  }
}

TEST(Evaluate, PointsOneRepresentableValueApartAreExact) {
  const double next = std::nextafter(0.3, 1.0);
  const TransferFunction tf = tf_of({point(0, 0), point(0.3, 0), point(next, 0.9), point(1, 0.1)});
  EXPECT_EQ(evaluate(tf, 0.3).opacity, 0);
  EXPECT_EQ(evaluate(tf, next).opacity, 0.9);
  EXPECT_EQ(evaluate_left(tf, next).opacity, 0.9);
}

TEST(Evaluate, AgreesWithALinearSearchInLongDouble) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int trial = 0; trial < 200; ++trial) {
    std::vector<ControlPoint> points;
    const int count = 1 + int(random() % 12);
    for (int i = 0; i < count; ++i) points.push_back(point(double(random() % 8), unit(random)));
    std::stable_sort(points.begin(), points.end(), [](auto& a, auto& b) { return a.value < b.value; });
    const TransferFunction tf = tf_of(points);
    for (int i = 0; i < 50; ++i) {
      const double v = i % 2 ? double(random() % 10) - 1 : 10 * unit(random) - 1;
      long double expected = points.front().opacity;
      for (std::size_t k = 0; k < points.size(); ++k) {
        if (points[k].value <= v) expected = points[k].opacity;
        if (k + 1 < points.size() && points[k].value < v && v < points[k + 1].value) {
          const long double t = ((long double)(v)-points[k].value) / (points[k + 1].value - points[k].value);
          expected = points[k].opacity * (1 - t) + points[k + 1].opacity * t;
          break;
        }
      }
      EXPECT_NEAR(evaluate(tf, v).opacity, double(expected), 1e-15) << "at " << v;
    }
  }
}

TEST(Extinction, IsWhatOneUnitAbsorbs) {
  EXPECT_DOUBLE_EQ(extinction(0.5, 2), std::log(2.0) / 2);
  EXPECT_DOUBLE_EQ(extinction(1e-12, 1), 1e-12 + 0.5e-24);
  EXPECT_EQ(extinction(0, 3), 0);
  EXPECT_DOUBLE_EQ(extinction(1, 1), 24 * std::log(2.0));
  EXPECT_EQ(extinction(1, 1), extinction(1 - 0x1p-30, 1));
}

TEST(Resolve, MapsNormalizedValuesAndVoxelsOntoTheVolume) {
  TransferFunction tf = tf_of({point(0, 0), point(0.25, 0.5), point(1, 0)});
  tf.domain = Domain::normalized;
  tf.unit = LengthUnit::voxel;
  tf.unit_distance = 4;
  tf.plateau_width = 0.1;
  const TransferFunction resolved = resolve(tf, {-100, 300}, 0.5);
  EXPECT_EQ(resolved.domain, Domain::data);
  EXPECT_EQ(resolved.unit, LengthUnit::world);
  EXPECT_EQ(resolved.unit_distance, 2);
  EXPECT_DOUBLE_EQ(resolved.plateau_width, 40);
  EXPECT_EQ(resolved.points[0].value, -100);
  EXPECT_EQ(resolved.points[1].value, 0);
  EXPECT_EQ(resolved.points[2].value, 300);
  EXPECT_EQ(resolve(resolved, {7, 9}, 3), resolved);
}

TEST(Resolve, ARangeOfNoWidthCountsAsOne) {
  TransferFunction tf = default_transfer_function();
  EXPECT_EQ(resolve(tf, {5, 5}, 1).range(), (ValueRange{5, 6}));
}

TEST(RemapValues, KeepsTheOrderAndSharedValues) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(-2, 3);
  for (int trial = 0; trial < 300; ++trial) {
    std::vector<ControlPoint> points;
    for (int i = 0; i < 20; ++i) {
      const double v = unit(random);
      points.push_back(point(v, 0.5));
      points.push_back(point(trial % 2 ? v : std::nextafter(v, 9.0), 0.5));
    }
    std::stable_sort(points.begin(), points.end(), [](auto& a, auto& b) { return a.value < b.value; });
    const double min = 1e3 * unit(random);
    const TransferFunction mapped =
        remap_values(tf_of(points), {-2, 3}, {min, min + 1e-3 * (4 + unit(random))});
    for (std::size_t i = 1; i < points.size(); ++i) {
      EXPECT_LE(mapped.points[i - 1].value, mapped.points[i].value);
      const bool shared = points[i - 1].value == points[i].value;
      EXPECT_TRUE(!shared || mapped.points[i - 1].value == mapped.points[i].value);
    }
  }
}

TEST(DefaultTransferFunction, ShowsSomethingOfAnyVolume) {
  const TransferFunction tf = default_transfer_function();
  EXPECT_EQ(tf.domain, Domain::normalized);
  EXPECT_EQ(tf.unit, LengthUnit::voxel);
  EXPECT_EQ(evaluate(tf, 0).opacity, 0);
  EXPECT_EQ(evaluate(tf, 1).opacity, 0.5);
  // Half of the range fills 64 voxels with something, and does not hide all behind 8.
  const double rho = extinction(evaluate(tf, 0.5).opacity, tf.unit_distance);
  EXPECT_GT(1 - std::exp(-64 * rho), 0.5);
  EXPECT_LT(1 - std::exp(-8 * rho), 0.5);
}

}  // namespace
}  // namespace crest
