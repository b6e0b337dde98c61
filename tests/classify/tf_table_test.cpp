#include "render/classify/tf_table.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/common.hpp>

#include "presets/preset_file.h"
#include "tests/classify/tf_of.h"

namespace crest {
namespace {

constexpr double longest_ray = 200;  // smallest spacings
constexpr ValueRange whole{0, 1};

/// What a texture unit makes of the table: linear between entries, constant beyond.
glm::dvec4 look_up(const TfTable& table, double value) {
  const double last = double(table.entries.size() - 1);
  const double place = std::clamp((value - table.range.min) / table.range.width() * last, 0.0, last);
  const std::size_t left = std::min(std::size_t(place), table.entries.size() - 2);
  return glm::mix(glm::dvec4(table.entries[left]), glm::dvec4(table.entries[left + 1]), place - double(left));
}

glm::dvec4 exact(const TransferFunction& tf, double value, double spacing) {
  const Classified c = evaluate(tf, value);
  return {c.color, extinction(c.opacity, tf.unit_distance) * spacing};
}

/// Between the opacities and premultiplied colours of a length of so many smallest spacings.
double difference(glm::dvec4 a, glm::dvec4 b, double length) {
  const double opacity_a = -std::expm1(-a.a * length), opacity_b = -std::expm1(-b.a * length);
  const glm::dvec4 d = glm::abs(glm::dvec4(opacity_a * glm::dvec3(a), opacity_a) -
                                glm::dvec4(opacity_b * glm::dvec3(b), opacity_b));
  return std::max({d.r, d.g, d.b, d.a});
}

/// Whether an entry's width about the value holds a step of the TF, or any point.
bool is_near_a_point(const TransferFunction& tf, double value, double width, bool steps_only) {
  for (std::size_t i = 0; i < tf.points.size(); ++i) {
    if (std::abs(tf.points[i].value - value) > width) continue;
    if (!steps_only || (i > 0 && tf.points[i].value == tf.points[i - 1].value)) return true;
  }
  return false;
}

/// From gentle to sharp, with steps or without.
TransferFunction any_tf(std::mt19937& random) {
  std::uniform_real_distribution<double> unit(0, 1);
  TransferFunction tf = random_tf(random, 8);
  const double strength = random() % 4 ? std::pow(10, -4 * unit(random)) : 1;
  for (std::size_t i = 0; i < tf.points.size(); ++i) {
    tf.points[i].opacity *= strength;
    if (random() % 2 && i > 0 && tf.points[i].value == tf.points[i - 1].value)
      tf.points[i].value += 0.01 * unit(random);
  }
  std::stable_sort(tf.points.begin(), tf.points.end(), [](auto& a, auto& b) { return a.value < b.value; });
  tf.unit_distance = std::pow(10, 2 * unit(random) - 0.5);
  return tf;
}

// The table against the TF itself, everywhere: no further off than its size says, and where nothing is
// blurred in it, within the limits.
TEST(TfTable, KeepsWhatItsSizeSays) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(0, 1);
  int smaller = 0;
  for (int trial = 0; trial < 3000; ++trial) {
    const TransferFunction tf = any_tf(random);
    ValueRange field{unit(random) * 0.5, 0};
    field.max = trial % 10 == 0 ? field.min : field.min + unit(random);
    field = {double(float(field.min)), double(float(field.max))};
    const TfTableLimits limits;
    const TfTableSize size = tf_table_size(tf, field, 1, longest_ray);
    const TfTable table = build_tf_table(tf, field, 1, size.entries);
    const double entry = table.range.width() / (size.entries - 1);
    const bool is_enough = size.entries < largest_tf_table && !size.blurred;
    smaller += is_enough;
    if (is_enough) {
      EXPECT_LE(size.error, limits.corner * (1 + 1e-9));
    } else {
      EXPECT_GE(size.entries, largest_tf_table / 2);
    }
    for (int i = 0; i < 300; ++i) {
      double value = field.min + unit(random) * field.width();
      if (i % 2) value = tf.points[random() % tf.points.size()].value + (unit(random) - 0.5) * 4 * entry;
      value = std::clamp(value, field.min, field.max);
      if (is_near_a_point(tf, value, entry, true)) continue;
      const glm::dvec4 found = look_up(table, value), right = exact(tf, value, 1);
      ASSERT_LE(difference(found, right, 1), 1.02 * size.error + 2e-6)
          << "trial " << trial << " at " << value << ", " << size.entries << " entries";
      if (!is_enough || is_near_a_point(tf, value, entry, false)) continue;
      const double length = std::min(longest_ray, 1 / std::max(right.a, 1e-9));
      ASSERT_LE(difference(found, right, length), 1.5 * limits.smooth + 2e-6)
          << "trial " << trial << " at " << value << ", " << size.entries << " entries";
    }
  }
  EXPECT_GT(smaller, 1000);
}

// A quarter of the entries would be too few for a corner, half of them for a curve.
TEST(TfTable, IsNoLargerThanItNeedsToBe) {
  const auto worst = [](const TransferFunction& tf, int entries, double length) {
    const TfTable table = build_tf_table(tf, whole, 1, entries);
    double most = 0;
    for (double v = 0; v <= 1; v += 1e-5)
      most = std::max(most, difference(look_up(table, v), exact(tf, v, 1), length));
    return most;
  };
  TransferFunction roof = tf_of({{0.1, 0}, {0.4567, 0.1}, {0.9, 0}});
  roof.unit_distance = 4;
  const int roof_entries = tf_table_size(roof, whole, 1, longest_ray).entries;
  EXPECT_LT(roof_entries, 2000);
  EXPECT_LT(worst(roof, roof_entries, 1), 1e-4);
  EXPECT_GT(worst(roof, roof_entries / 4, 1), 1e-4);

  TransferFunction ramp = tf_of({{0, 0.3}, {1, 0.9}});
  ramp.unit_distance = 50;
  const int ramp_entries = tf_table_size(ramp, whole, 1, longest_ray).entries;
  EXPECT_LT(ramp_entries, 2000);
  const double length = 1 / extinction(0.9, 50);
  EXPECT_LT(worst(ramp, ramp_entries, length), 1.5e-5);
  EXPECT_GT(worst(ramp, ramp_entries / 2, length), 1.5e-5);
}

TEST(TfTable, GrowsWithTheNarrowestFeatureInTheField) {
  int before = 0;
  for (const double width : {0.4, 0.2, 0.1, 0.05}) {
    TransferFunction tf =
        tf_of({{0, 0.01}, {0.5 - width, 0.01}, {0.5, 0.05}, {0.5 + width, 0.01}, {1, 0.01}});
    tf.unit_distance = 10;
    const TfTableSize size = tf_table_size(tf, whole, 1, longest_ray);
    EXPECT_GE(size.entries, before) << width;
    EXPECT_LT(size.entries, 1024) << width;
    before = size.entries;
  }
  // A spike among gentle haze: only where the field has its value
  TransferFunction tf = tf_of({{0, 0.02}, {0.49995, 0.02}, {0.5, 0.9}, {0.50005, 0.02}, {1, 0.03}});
  tf.unit_distance = 10;
  EXPECT_EQ(tf_table_size(tf, whole, 1, longest_ray).entries, largest_tf_table);
  EXPECT_LT(tf_table_size(tf, {0, 0.4}, 1, longest_ray).entries, 64);
  EXPECT_LT(tf_table_size(tf, {0.6, 1}, 1, longest_ray).entries, 64);
}

TEST(TfTable, CoversOnlyWhatChanges) {
  const TfTable spike =
      build_tf_table(tf_of({{0, 0}, {0.4999, 0}, {0.5, 0.9}, {0.5001, 0}, {1, 0}}), whole, 1, 100);
  EXPECT_NEAR(spike.range.min, 0.4999, 1e-7);
  EXPECT_NEAR(spike.range.max, 0.5001, 1e-7);
  // Colour does not matter where nothing is shown
  TransferFunction colored = tf_of({{0, 0}, {0.3, 0}, {0.6, 0.5}, {1, 0.5}});
  colored.points[0].color = {1, 0, 0};
  colored.points[3].color = colored.points[2].color = {0, 1, 0};
  const ValueRange range = build_tf_table(colored, whole, 1, 10).range;
  EXPECT_NEAR(range.min, 0.3, 1e-7);
  EXPECT_NEAR(range.max, 0.6, 1e-7);
  for (const auto& constant : {tf_of({{0.2, 0.4}, {0.7, 0.4}}), tf_of({{2, 0.4}, {3, 0.9}}), tf_of({})})
    EXPECT_EQ(tf_table_size(constant, whole, 1, longest_ray).entries, 2);
}

// A TF that is constant but for one step is as sharp as floats allow, with two entries.
TEST(TfTable, OneStepTakesTwoEntries) {
  const TransferFunction tf = tf_of({{0.3, 0.1}, {0.3, 0.8}});
  const TfTableSize size = tf_table_size(tf, whole, 1, longest_ray);
  EXPECT_EQ(size.entries, 2);
  EXPECT_FALSE(size.blurred);
  const TfTable table = build_tf_table(tf, whole, 1, size.entries);
  EXPECT_NEAR(look_up(table, 0.3 - 2e-6).a, extinction(0.1, 1), 1e-6);
  EXPECT_NEAR(look_up(table, 0.3 + 2e-6).a, extinction(0.8, 1), 1e-6);
}

TEST(TfTable, SaysWhatItBlurs) {
  const TfTableSize step =
      tf_table_size(tf_of({{0, 0}, {0.3, 0.1}, {0.3, 0.8}, {1, 0.5}}), whole, 1, longest_ray);
  EXPECT_EQ(step.entries, largest_tf_table);
  ASSERT_TRUE(step.blurred);
  EXPECT_EQ(*step.blurred, (ValueRange{0.3, 0.3}));
  EXPECT_NEAR(step.error, 0.7, 1e-9);
  const TfTableSize spike = tf_table_size(
      tf_of({{0, 0.1}, {0.39999, 0.1}, {0.4, 0.9}, {0.4001, 0.1}, {1, 0.2}}), whole, 1, longest_ray);
  ASSERT_TRUE(spike.blurred);
  EXPECT_EQ(*spike.blurred, (ValueRange{0.39999, 0.4}));
  EXPECT_FALSE(
      tf_table_size(tf_of({{0, 0.1}, {0.3, 0.1}, {0.4, 0.9}, {0.5, 0.1}, {1, 0.2}}), whole, 1, longest_ray)
          .blurred);
}

TEST(TfTable, LargestOpacityIsThatOfTheFieldsValues) {
  const TransferFunction tf =
      tf_of({{0, 0.1}, {0.2, 0.5}, {0.4, 0.1}, {0.6, 0.1}, {0.6, 0.9}, {0.6, 0.2}, {1, 0.2}});
  EXPECT_EQ(largest_opacity(tf, {0, 0.3}), 0.5);
  EXPECT_DOUBLE_EQ(largest_opacity(tf, {0, 0.1}), 0.3);
  EXPECT_DOUBLE_EQ(largest_opacity(tf, {0.3, 1}), 0.3);  // the true spike at 0.6 is met by no sample
  EXPECT_EQ(largest_opacity(tf, {2, 3}), 0.2);
  EXPECT_EQ(largest_opacity(tf, {0.2, 0.2}), 0.5);
  EXPECT_EQ(largest_opacity(tf_of({}), whole), 0);
}

// A mask: nothing below 1, and something at 1 itself, which all of its inside has.
TEST(TfTable, HoldsAStepAtTheGreatestValue) {
  TransferFunction tf;
  for (const auto& [value, opacity] : {std::pair(0.0, 0.0), {1.0, 0.0}, {1.0, 0.3}, {2.0, 0.3}})
    tf.points.push_back({.value = value, .opacity = opacity, .surface = {}, .unknown = {}});
  EXPECT_EQ(largest_opacity(tf, whole), 0.3);
  const TfTableSize size = tf_table_size(tf, whole, 1, longest_ray);
  const TfTable table = build_tf_table(tf, whole, 1, size.entries);
  EXPECT_NEAR(look_up(table, 1).a, extinction(0.3, 1), 1e-6);
  EXPECT_EQ(look_up(table, 0.999).a, 0);
}

// Labels: what the TF has at a step's own value is what a region of that value shows.
TEST(TfTable, HasEachStepBetweenWholeNumbersOnAnEntry) {
  TransferFunction tf;
  double before = 0;
  for (const double label : {1.0, 2.0, 7.0, 23.0}) {
    const double opacity = 0.02 * label;
    tf.points.push_back({.value = label, .opacity = before, .surface = {}, .unknown = {}});
    tf.points.push_back({.value = label, .opacity = opacity, .surface = {}, .unknown = {}});
    before = opacity;
  }
  const ValueRange field{0, 30};
  const TfTableSize size = tf_table_size(tf, field, 1, longest_ray);
  const TfTable table = build_tf_table(tf, field, 1, size.entries);
  for (const double label : {1.0, 2.0, 7.0, 23.0})
    EXPECT_NEAR(look_up(table, label).a, extinction(0.02 * label, 1), 1e-5) << label;
}

}  // namespace
}  // namespace crest
