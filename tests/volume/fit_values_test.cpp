#include "render/volume/fit_values.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "presets/error.h"
#include "presets/peaks.h"
#include "render/volume/builtin.h"
#include "render/volume/random.h"
#include "tests/classify/tf_of.h"

namespace crest::test {
namespace {

Volume with_values(Volume volume, const std::function<double(double)>& map) {
  for (float& value : volume.values.floats()) value = float(map(double(value)));
  volume.statistics = compute_statistics(volume.grid, volume.values);
  return volume;
}

double cubic(double v) { return 200 + 7 * v + v * v * v; }
double cubic_slope(double v) { return 7 + 3 * v * v; }

/// Half a bin to each side and a gap without voxels beside it, by the cubic's slope.
double bound(const ValueFit& fit, double v) {
  return cubic_slope(v) * fit.from_range.width() / 65536 + 6 * std::abs(v) * 1e-6;
}

TEST(FitValues, AKnownMonotoneMapIsFound) {
  const Volume volume = make_builtin("noise?n=64");
  const ValueFit fit = fit_values(volume, with_values(volume, cubic));
  EXPECT_FALSE(fit.is_decreasing);
  EXPECT_GT(fit.explained, 1 - 1e-6);
  for (double v = -2; v < 2; v += 0.003) EXPECT_NEAR(fitted_value(fit, v), cubic(v), bound(fit, v)) << v;
}

TEST(FitValues, NotEveryMapThatKeepsTheSharesIsTheRightOne) {
  // Other places: histograms are the same, and tell nothing; places do
  const Volume volume = make_builtin("noise?n=32");
  Volume turned = volume;
  std::ranges::reverse(turned.values.floats());
  turned.statistics = compute_statistics(turned.grid, turned.values);
  EXPECT_LT(fit_values(volume, turned).explained, 0.35);
  EXPECT_GT(fit_values(volume, volume).explained, 1 - 1e-9);
}

TEST(FitValues, AirAroundOneOfTheTwoChangesNothing) {
  const Volume volume = make_builtin("noise?n=48");
  Volume cropped = with_values(volume, cubic);
  for (std::size_t i = 0; i < cropped.values.size() / 2; ++i) cropped.values.floats()[i] = NAN;
  cropped.statistics = compute_statistics(cropped.grid, cropped.values);
  const ValueFit fit = fit_values(volume, cropped);
  for (double v = -1.5; v < 1.5; v += 0.01) EXPECT_NEAR(fitted_value(fit, v), cubic(v), 4 * bound(fit, v));
}

TEST(FitValues, NoiseInTheOtherVolumeIsAveragedOut) {
  const Volume volume = make_builtin("noise?n=64");
  Random random(3);
  const double amplitude = 4;
  const Volume noisy =
      with_values(volume, [&](double v) { return cubic(v) + random.uniform(-amplitude, amplitude); });
  const ValueFit fit = fit_values(volume, noisy);
  EXPECT_LT(fit.explained, 1);
  double worst = 0;
  for (double v = -1.5; v < 1.5; v += 0.01)
    worst = std::max(worst, std::abs(fitted_value(fit, v) - cubic(v)));
  EXPECT_LT(worst, amplitude / 4);
}

TEST(FitValues, IsTheLeastOfAllMonotoneMaps) {
  // By brute force over maps of three values to a grid of numbers
  Volume a = make_builtin("linear?n=2"), b = a;
  a.values = std::vector<float>{0, 0, 1, 1, 2, 2, 2, 2};
  b.values = std::vector<float>{1, 2, 5, 7, 3, 4, 4, 3};
  for (Volume* volume : {&a, &b}) volume->statistics = compute_statistics(volume->grid, volume->values);
  const auto error = [&](const std::function<double(int)>& map) {
    double sum = 0;
    for (std::size_t i = 0; i < a.values.size(); ++i)
      sum += std::pow(double(b.values[i]) - map(int(a.values[i])), 2);
    return sum;
  };
  double least = 1e9;
  for (double x = 0; x <= 8; x += 0.125)
    for (double y = x; y <= 8; y += 0.125)
      for (double z = y; z <= 8; z += 0.125)
        least = std::min(least, error([&](int i) { return i == 0 ? x : i == 1 ? y : z; }));
  const ValueFit fit = fit_values(a, b);
  const double found = error([&](int i) { return fitted_value(fit, i); });
  EXPECT_LE(found, least + 1e-9);
  EXPECT_GT(found, least - 0.1);
  EXPECT_EQ(fitted_value(fit, 1), fitted_value(fit, 2));
}

TEST(FitValues, WhatIsDarkInTheOtherTurnsThePoints) {
  const Volume volume = make_builtin("noise?n=48");
  const ValueFit fit = fit_values(volume, with_values(volume, [](double v) { return -cubic(v); }));
  EXPECT_TRUE(fit.is_decreasing);
  const TransferFunction tf =
      tf_of({{-1, 0.1}, {0.499, 0.1}, {0.5, 0.7}, {0.501, 0.1}, {0.8, 0.2}, {0.8, 0.6}});
  const TransferFunction result = carried(tf, fit);
  ASSERT_EQ(result.points.size(), 6U);
  for (std::size_t i = 1; i < 6; ++i) EXPECT_GE(result.points[i].value, result.points[i - 1].value);
  EXPECT_NEAR(result.points[3].value, -cubic(0.5), bound(fit, 0.5));
  EXPECT_EQ(result.points[3].opacity, 0.7);
  EXPECT_EQ(result.points[0].opacity, 0.6);
  EXPECT_TRUE(find_peaks(result).front().spike);
}

TEST(FitValues, OtherGridsAndVolumesWithoutValuesAreRefused) {
  const Volume volume = make_builtin("noise?n=8");
  EXPECT_THROW(fit_values(volume, make_builtin("noise?n=9")), Error);
  EXPECT_THROW(fit_values(volume, with_values(volume, [](double) { return NAN; })), Error);
  const ValueFit flat = fit_values(volume, with_values(volume, [](double) { return 3; }));
  EXPECT_NEAR(fitted_value(flat, 0.1), 3, 1e-9);
}

}  // namespace
}  // namespace crest::test
