#include "render/volume/filter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "render/volume/filter_bounds.h"
#include "tests/raycaster/reconstruct.h"

namespace crest {
namespace {

double value_at(const CubicWeight& w, double u) { return w[0] + u * (w[1] + u * (w[2] + u * w[3])); }
double slope_at(const CubicWeight& w, double u) { return w[1] + u * (2 * w[2] + u * 3 * w[3]); }

const FieldFilter all_filters[] = {{Filter::linear},   {Filter::linear_exact}, {Filter::bspline},
                                   {Filter::bc, 1, 0}, {Filter::bc, 0, 0.5},   {Filter::bc, 1.0 / 3, 1.0 / 3},
                                   {Filter::bc, 2, 1}, {Filter::bc, -3, 2.5}};

TEST(FilterWeights, AreTheKernelAtTheFourDistances) {
  for (const FieldFilter& filter : all_filters) {
    if (radius_of(filter) != 2) continue;
    const double b = filter.kind == Filter::bspline ? 1 : filter.b;
    const auto weights = filter_weights(filter);
    for (double u = 0; u <= 1; u += 1.0 / 64)
      for (int i = 0; i < 4; ++i)
        EXPECT_NEAR(value_at(weights[std::size_t(i)], u), testing::cubic_kernel(b, filter.c, u + 1 - i),
                    1e-13);
  }
}

TEST(FilterWeights, SumToOneEverywhere) {
  for (const FieldFilter& filter : all_filters) {
    CubicWeight sum{};
    for (const CubicWeight& w : filter_weights(filter))
      for (std::size_t k = 0; k < 4; ++k) sum[k] += w[k];
    EXPECT_NEAR(sum[0], 1, 1e-14);
    for (std::size_t k = 1; k < 4; ++k) EXPECT_NEAR(sum[k], 0, 1e-14);
  }
}

TEST(FilterWeights, JoinWithTheirDerivativeFromCellToCell) {
  for (const FieldFilter& filter : all_filters) {
    if (radius_of(filter) != 2) continue;
    const auto w = filter_weights(filter);
    for (std::size_t i = 0; i < 5; ++i) {  // point i - 1 of one cell is point i - 2 of the next
      const double before = i < 4 ? value_at(w[i], 1) : 0, after = i > 0 ? value_at(w[i - 1], 0) : 0;
      const double slope_before = i < 4 ? slope_at(w[i], 1) : 0,
                   slope_after = i > 0 ? slope_at(w[i - 1], 0) : 0;
      EXPECT_NEAR(before, after, 1e-13);
      EXPECT_NEAR(slope_before, slope_after, 1e-13);
    }
  }
}

TEST(FilterWeights, OfTheLineOfGoodFiltersReproduceALinearFunctionAndOfCatmullRomAQuadraticOne) {
  for (const double b : {0.0, 1.0 / 3, 1.0}) {  // 2C + B = 1 (Mitchell and Netravali, section 4)
    const auto w = filter_weights({Filter::bc, b, (1 - b) / 2});
    for (double u = 0; u <= 1; u += 1.0 / 64) {
      double linear = 0, quadratic = 0;
      for (int i = 0; i < 4; ++i) {
        linear += value_at(w[std::size_t(i)], u) * (i - 1);
        quadratic += value_at(w[std::size_t(i)], u) * (i - 1) * (i - 1);
      }
      EXPECT_NEAR(linear, u, 1e-14);
      EXPECT_NEAR(quadratic, u * u + b / 3, 1e-14) << "a smoothing member adds its variance";
    }
  }
}

TEST(FilterWeights, OfThePapersBAndCAreNotMonotone) {
  const auto w = filter_weights({Filter::bc, 2, 1});
  const double place[] = {0, 0.1, 0.25, 0.5, 0.75, 0.9, 1};
  const double expected[] = {0, 0.32, 0.53, 0.50, 0.47, 0.68, 1};  // of the ramp that is the place itself
  for (std::size_t at = 0; at < 7; ++at) {
    double sum = 0;
    for (int i = 0; i < 4; ++i) sum += value_at(w[std::size_t(i)], place[at]) * (i - 1);
    EXPECT_NEAR(sum, expected[at], 0.005);
  }
}

TEST(FilterBounds, AreThoseOfTheTrilinearFieldForTheBSpline) {
  for (const Filter kind : {Filter::linear, Filter::linear_exact, Filter::bspline}) {
    EXPECT_EQ(filter_bounds({kind}).overshoot, 0);
    EXPECT_EQ(filter_bounds({kind}).steepness, 1);
  }
  const FilterBounds as_bc = filter_bounds({Filter::bc, 1, 0});
  EXPECT_NEAR(as_bc.overshoot, 0, 1e-14);
  EXPECT_NEAR(as_bc.steepness, 1, 1e-14);
}

TEST(FilterBounds, OfCatmullRomAreThoseOfItsOneDimensionalExtremes) {
  // sum |w| is 1 - 2 (negative part), -(u - u^2)/2 in the middle: 1.25 at u = 1/2
  const FilterBounds bounds = filter_bounds({Filter::bc, 0, 0.5});
  EXPECT_EQ(bounds.radius, 2);
  EXPECT_NEAR(bounds.overshoot, (1.25 * 1.25 * 1.25 - 1) / 2, 1e-14);
}

/// The worst of many random supports comes near to the bounds and never beyond.
TEST(FilterBounds, HoldForRandomSupportsAndAreReachedOnAnAxis) {
  std::mt19937 random(7);
  for (const FieldFilter& filter : all_filters) {
    const auto w = filter_weights(filter);
    const FilterBounds bounds = filter_bounds(filter);
    const double sum = std::cbrt(2 * bounds.overshoot + 1);
    double most_over = 0, most_steep = 0;
    for (int trial = 0; trial < 20000; ++trial) {
      const double u = double(trial % 257) / 256;
      double value = 0, slope = 0, v[4];
      for (int i = 0; i < 4; ++i) {
        v[i] = double(random() % 2);
        value += value_at(w[std::size_t(i)], u) * v[i];
        slope += slope_at(w[std::size_t(i)], u) * v[i];
      }
      most_over = std::max(most_over, value - 1);
      double difference = 0;
      const int first = bounds.radius == 1 ? 1 : 0, last = bounds.radius == 1 ? 2 : 3;
      for (int i = first; i < last; ++i) difference = std::max(difference, std::abs(v[i + 1] - v[i]));
      if (difference > 0) most_steep = std::max(most_steep, std::abs(slope) / difference);
    }
    EXPECT_LE(most_over, (sum - 1) / 2 + 1e-12);
    EXPECT_GE(most_over, 0.98 * (sum - 1) / 2 - 1e-12);
    EXPECT_LE(most_steep, bounds.steepness / (sum * sum) + 1e-12);
  }
}

TEST(FilterBounds, WidenARangeByTheOvershoot) {
  const FieldFilter catmull_rom{Filter::bc, 0, 0.5};
  const double beyond = filter_bounds(catmull_rom).overshoot;
  const ValueRange range = field_range(catmull_rom, {10, 14});
  EXPECT_DOUBLE_EQ(range.min, 10 - 4 * beyond);
  EXPECT_DOUBLE_EQ(range.max, 14 + 4 * beyond);
  EXPECT_EQ(field_range({Filter::bspline}, {10, 14}).max, 14);
}

TEST(FieldFilter, OfTheRootsIsThatOfTheSamplesUnlessItIsSet) {
  Rendering rendering;
  rendering.filter = Filter::bspline;
  EXPECT_EQ(root_filter(rendering), dvr_filter(rendering));
  rendering.root_filter = Filter::bc;
  EXPECT_EQ(root_filter(rendering), (FieldFilter{Filter::bc, rendering.bc_b, rendering.bc_c}));
  rendering.root_filter = Filter::bspline;
  EXPECT_EQ(root_filter(rendering), dvr_filter(rendering));
}

}  // namespace
}  // namespace crest
