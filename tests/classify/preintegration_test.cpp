#include <gtest/gtest.h>

#include <boost/math/quadrature/tanh_sinh.hpp>
#include <cmath>
#include <glm/common.hpp>
#include <numbers>

#include "presets/error.h"
#include "render/classify/antiderivatives.h"
#include "render/classify/mean_material.h"
#include "render/classify/preintegration_table.h"
#include "tests/classify/tf_of.h"

namespace crest {
namespace {

constexpr ValueRange whole{0, 1};
constexpr double most = 24 * std::numbers::ln2;

/// Emission and extinction of one unit distance.
glm::dvec4 material_at(const TransferFunction& tf, double value) {
  const Classified c = evaluate(tf, value);
  const double rho = extinction(c.opacity, 1);
  return {rho * c.color, rho};
}

/// The integral of the material over a range of values, piece by piece.
glm::dvec4 integral(const TransferFunction& tf, double from, double to) {
  boost::math::quadrature::tanh_sinh<double> rule;
  std::vector<double> cuts{from};
  for (const ControlPoint& point : tf.points)
    if (point.value > cuts.back() && point.value < to) cuts.push_back(point.value);
  cuts.push_back(to);
  glm::dvec4 sum(0);
  for (std::size_t i = 1; i < cuts.size(); ++i)
    for (int channel = 0; channel < 4; ++channel)
      if (const double a = cuts[i - 1], b = cuts[i]; b > a) {
        const Classified begin = evaluate_right(tf, a), end = evaluate_left(tf, b);
        sum[channel] +=
            (b - a) *
            rule.integrate(
                [&](double x, double) {
                  const double rho = extinction(std::lerp(begin.opacity, end.opacity, x), 1);
                  return channel == 3 ? rho : rho * std::lerp(begin.color[channel], end.color[channel], x);
                },
                0.0, 1.0);
      }
  return sum;
}

TEST(MeanMaterial, IsTheIntegralOfALinearStretch) {
  const double opacities[] = {0, 1e-12, 1e-5, 0.1, 0.1 + 1e-9, 0.19, 0.5, 0.9, 1 - 1e-6, 1 - 1e-9, 1};
  for (const double a : opacities)
    for (const double b : opacities) {
      TransferFunction tf = tf_of({{0, a}, {1, b}});
      tf.points[0].color = {1, 0, 0.25};
      tf.points[1].color = {1, 1, 0.75};
      const glm::dvec4 found = mean_material(evaluate(tf, 0), evaluate(tf, 1)), right = integral(tf, 0, 1);
      for (int channel = 0; channel < 4; ++channel)
        // The quadrature has a kink at the cap
        EXPECT_NEAR(found[channel], right[channel],
                    1e-12 * right[channel] + (std::max(a, b) > 0.99 ? 1e-7 : 0))
            << a << ' ' << b << ' ' << channel;
    }
  EXPECT_DOUBLE_EQ(mean_material({{1, 1, 1}, 0}, {{1, 1, 1}, 1}).a, 1 - 0x1p-24);  // with the cap
  EXPECT_DOUBLE_EQ(mean_material({{1, 1, 1}, 1}, {{1, 1, 1}, 1}).a, most);
}

TEST(MeanMaterial, LosesNothingThatLiesWithinAStretch) {
  std::mt19937 random(5);
  for (int trial = 0; trial < 200; ++trial) {
    TransferFunction tf = random_tf(random, 9);
    for (ControlPoint& point : tf.points) point.opacity *= 0.98;
    const int count = 1 + int(random() % 20);
    const auto means = mean_materials(tf, whole, count);
    for (int i = 0; i < count; ++i) {
      const glm::dvec4 right = integral(tf, double(i) / count, double(i + 1) / count) * double(count);
      for (int channel = 0; channel < 4; ++channel)
        ASSERT_NEAR(means[std::size_t(i)][channel], right[channel], 1e-11) << trial;
    }
  }
}

/// The shader's look-up (preintegration.glsl), in float: the mean material between two values.
glm::vec4 mean_between(const Antiderivatives& table, float f0, float f1) {
  struct Place {
    float entry, x;
    const Antiderivatives::Entry* at;
  };
  const float scale = float(double(table.entries.size() - 2) / table.range.width());
  const auto place_of = [&](float value) {
    const float position = (value - float(table.range.min)) * scale + 1;
    const float entry = std::clamp(std::floor(position), 0.0f, float(table.entries.size() - 1));
    return Place{entry, position - entry, &table.entries[std::size_t(entry)]};
  };
  const Place a = place_of(f0), b = place_of(f1);
  const float apart = std::abs(b.entry - a.entry);
  if (apart == 0) return a.at->mean + (0.5f * (a.x + b.x) - 0.5f) * a.at->slope;
  const bool rising = b.entry > a.entry;
  const float leave = rising ? 1 : 0, in_a = std::abs(leave - a.x), in_b = std::abs(b.x + leave - 1);
  glm::vec4 sum = in_a * (a.at->mean + 0.5f * (a.x + leave - 1) * a.at->slope) +
                  in_b * (b.at->mean + 0.5f * (b.x - leave) * b.at->slope);
  if (apart > 1) {
    const glm::vec4 between = glm::abs((b.at->sum_high - a.at->sum_high) + (b.at->sum_low - a.at->sum_low));
    sum += glm::max(between - (rising ? a.at->mean : b.at->mean), glm::vec4(0));
  }
  return sum / (in_a + in_b + apart - 1);
}

TransferFunction gentle() {
  TransferFunction tf = tf_of({{0.1, 0.02}, {0.4, 0.3}, {0.8, 0.1}});
  tf.points[0].color = {0, 0.5, 1};
  tf.points[1].color = {1, 0.25, 0.5};
  return tf;
}

// Between any two values, near each other or not, rising or falling, within the TF's span or beyond: the mean
// in float.
TEST(Antiderivatives, GiveTheMeanBetweenAnyTwoValues) {
  const TransferFunction tf = gentle();
  const Antiderivatives table = build_antiderivatives(tf, whole, 1, 2000);
  std::mt19937 random(2);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int trial = 0; trial < 4000; ++trial) {
    const float f0 = float(unit(random));
    float f1 = float(unit(random));
    if (trial % 2) f1 = std::clamp(f0 + (f1 - 0.5f) * float(std::pow(10, -8 * unit(random))), 0.0f, 1.0f);
    const float low = std::min(f0, f1), high = std::max(f0, f1);
    const glm::dvec4 right = low == high ? material_at(tf, double(low))
                                         : integral(tf, double(low), double(high)) / double(high - low);
    const glm::vec4 found = mean_between(table, f0, f1);
    // Within an entry the TF is a line, so that a corner is rounded off
    const bool is_near_a_corner = std::ranges::any_of(tf.points, [&](const ControlPoint& p) {
      return std::min(std::abs(p.value - double(low)), std::abs(p.value - double(high))) < 1e-3;
    });
    for (int channel = 0; channel < 4; ++channel)
      ASSERT_NEAR(found[channel], right[channel], is_near_a_corner ? 1e-4 : 2e-7)
          << f0 << ' ' << f1 << ' ' << channel;
  }
}

// No cancellation: the sums' two floats keep the difference of neighbouring entries, behind an opaque spike
// too.
TEST(Antiderivatives, KeepFaintHazeBehindAnOpaqueSpike) {
  TransferFunction tf = tf_of({{0, 1e-6}, {0.1, 1e-6}, {0.1001, 1}, {0.1002, 1e-6}, {1, 2e-6}});
  const Antiderivatives table = build_antiderivatives(tf, whole, 1, largest_preintegration_table);
  for (float f0 = 0.2f; f0 < 0.9f; f0 += 0.0137f)
    for (const float change : {0.0f, 1e-7f, 1e-5f, 4e-4f, 1e-3f, 0.05f}) {
      const double low = double(f0), high = double(f0 + change);
      const double right = high > low ? integral(tf, low, high).a / (high - low) : material_at(tf, low).a;
      EXPECT_NEAR(mean_between(table, f0, f0 + change).a, right, 1e-5 * right) << f0 << ' ' << change;
      EXPECT_NEAR(mean_between(table, f0 + change, f0).a, right, 1e-5 * right);
    }
}

TEST(Antiderivatives, ASpikeNarrowerThanAnEntryKeepsItsIntegral) {
  for (const double half : {1e-4, 1e-6, 1e-9}) {
    const TransferFunction tf = tf_of({{0, 0.1}, {0.3 - half, 0.1}, {0.3, 0.9}, {0.3 + half, 0.1}, {1, 0.2}});
    const Antiderivatives table = build_antiderivatives(tf, whole, 1, 500);
    const double spike = integral(tf, 0.3 - half, 0.3 + half).a;
    EXPECT_NEAR(mean_between(table, 0.29f, 0.31f).a * 0.02f, integral(tf, 0.29, 0.31).a, 1e-3 * spike + 2e-8);
    EXPECT_NEAR(mean_between(table, 0.31f, 0.29f).a * 0.02f, integral(tf, 0.29, 0.31).a, 1e-3 * spike + 2e-8);
  }
}

// Every entry's line is a material at both ends, whatever the TF does in it.
TEST(Antiderivatives, AreMaterialsEverywhere) {
  std::mt19937 random(9);
  for (int trial = 0; trial < 500; ++trial) {
    const TransferFunction tf = random_tf(random, 12);
    const Antiderivatives table = build_antiderivatives(tf, {0.1, 0.9}, 1, 1 + int(random() % 64));
    for (const auto& entry : table.entries)
      for (const glm::vec4 end : {entry.mean - 0.5f * entry.slope, entry.mean + 0.5f * entry.slope})
        for (int channel = 0; channel < 4; ++channel) {
          ASSERT_GE(end[channel], -2e-5f);
          ASSERT_LE(end[channel], end.a + 2e-5f);
        }
  }
}

/// A segment on which the field is linear: its colour and opacity by the midpoint rule, in so many pieces.
glm::dvec4 segment(const TransferFunction& tf, double f0, double f1, double length, int pieces) {
  glm::dvec4 sum(0);
  for (int i = 0; i < pieces; ++i) {
    const glm::dvec4 material = material_at(tf, std::lerp(f0, f1, (i + 0.5) / pieces));
    const double alpha = -std::expm1(-material.a * length / pieces);
    if (material.a > 0) sum += (1 - sum.a) * alpha * glm::dvec4(glm::dvec3(material) / material.a, 1);
  }
  return sum;
}

double largest_error(const PreintegrationTable& table, const TransferFunction& tf, int bins_apart) {
  double largest = 0;
  for (int front = 0; front < table.bins; front += bins_apart)
    for (int back = 0; back < table.bins; back += bins_apart) {
      const auto value = [&](int bin) {
        return table.range.min + table.range.width() * bin / (table.bins - 1);
      };
      const glm::dvec4 d = glm::abs(glm::dvec4(table.at(front, back)) -
                                    segment(tf, value(front), value(back), table.length, 20000));
      largest = std::max({largest, d.r, d.g, d.b, d.a});
    }
  return largest;
}

// Along the diagonals as by itself, entry by entry; the difference is of second order in the bins.
TEST(PreintegrationTable, IsTheDirectIntegral) {
  TransferFunction tf = gentle();
  tf.points.insert(tf.points.begin() + 2, tf.points[1]);
  tf.points[2].value = 0.6;
  tf.points[2].opacity = 0.95;
  tf.points[2].color = {0, 1, 0};
  for (const double length : {0.1, 1.0, 30.0}) {
    const double coarse = largest_error(build_preintegration_table(tf, whole, 1, length, 21), tf, 1);
    const double fine = largest_error(build_preintegration_table(tf, whole, 1, length, 81), tf, 4);
    EXPECT_LT(coarse, 0.05) << length;
    EXPECT_LT(fine, std::max(coarse / 8, 2e-6)) << length;
  }
}

TEST(PreintegrationTable, HoldsStepsAndOpaqueMaterials) {
  TransferFunction tf = tf_of({{0, 0}, {0.25, 0}, {0.25, 1}, {0.5, 1}, {0.5, 0.2}, {1, 0.2}});
  for (std::size_t i = 4; i < 6; ++i) tf.points[i].color = {1, 0, 0};
  const PreintegrationTable table = build_preintegration_table(tf, whole, 1, 8, 5);
  EXPECT_NEAR(table.at(0, 1).a, 0, 1e-7);
  EXPECT_NEAR(table.at(4, 1).a, 1, 1e-7);
  // From 1 down to 0.5 in two thirds of the segment, through red haze; behind it all is white and opaque
  const double red = 1 - std::pow(0.8, 8.0 * 2 / 3);
  EXPECT_NEAR(table.at(4, 1).r, 1, 1e-6);
  EXPECT_NEAR(table.at(4, 1).g, 1 - red, 1e-6);
  EXPECT_NEAR(table.at(1, 4).g, 1, 1e-6);
  EXPECT_NEAR(table.at(3, 3).a, 1 - std::pow(0.8, 8), 1e-6);
  EXPECT_THROW(build_preintegration_table(tf, whole, 1, 8, 1), Error);
  EXPECT_THROW(build_preintegration_table(tf, whole, 1, 8, largest_preintegration_table + 1), Error);
}

TEST(PreintegrationTable, ASpikeNarrowerThanABinKeepsItsIntegral) {
  const TransferFunction tf = tf_of({{0, 0}, {0.3 - 1e-6, 0}, {0.3, 0.9}, {0.3 + 1e-6, 0}, {1, 0}});
  const PreintegrationTable table = build_preintegration_table(tf, whole, 1, 1e5, 64);
  const double depth = integral(tf, 0.3 - 1e-6, 0.3 + 1e-6).a * 1e5;
  EXPECT_NEAR(table.at(0, 63).a, -std::expm1(-depth), 1e-6);
  EXPECT_NEAR(table.at(63, 0).a, -std::expm1(-depth), 1e-6);
  EXPECT_EQ(table.at(30, 63).a, 0);
}

TEST(PreintegrationTable, OfAConstantField) {
  for (const double value : {0.5, 0.0, -3e20}) {
    const PreintegrationTable table =
        build_preintegration_table(tf_of({{0, 0.3}, {1, 0.3}}), {value, value}, 1, 2, 2);
    EXPECT_GT(table.range.width(), 0);
    for (const glm::vec4& entry : table.entries) EXPECT_NEAR(entry.a, 1 - 0.7 * 0.7, 1e-6);
  }
}

}  // namespace
}  // namespace crest
