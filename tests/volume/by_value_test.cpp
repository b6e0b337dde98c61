#include "render/volume/by_value.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <numeric>

#include "render/volume/builtin.h"
#include "render/volume/suggested_peaks.h"

namespace crest::test {
namespace {

using std::numbers::pi;

double sum(const std::vector<double>& values) { return std::accumulate(values.begin(), values.end(), 0.0); }

ByValue measured(const Volume& volume, int bins = by_value_bins) { return *measure_by_value(volume, bins); }

Volume volume_of(const Grid& grid, const std::function<double(glm::dvec3)>& field) {
  Volume volume;
  volume.grid = grid;
  for (int k = 0; k < grid.dims.z; ++k)
    for (int j = 0; j < grid.dims.y; ++j)
      for (int i = 0; i < grid.dims.x; ++i)
        volume.values.floats().push_back(float(field(grid.origin + grid.spacing * glm::dvec3(i, j, k))));
  volume.statistics = compute_statistics(volume.grid, volume.values);
  return volume;
}

/// The part of the box 0 .. size in which g . x < t, by inclusion and exclusion of its corners.
double box_below(glm::dvec3 g, glm::dvec3 size, double t) {
  double total = 0;
  for (int corner = 0; corner < 8; ++corner) {
    const glm::dvec3 at{corner & 1, corner >> 1 & 1, corner >> 2 & 1};
    const double left = std::max(t - glm::dot(g, at * size), 0.0);
    total +=
        ((corner & 1) + (corner >> 1 & 1) + (corner >> 2 & 1)) % 2 ? -std::pow(left, 3) : std::pow(left, 3);
  }
  return total / (6 * g.x * g.y * g.z);
}

void expect_exact_for_linear(const ByValue& found, glm::dvec3 g, glm::dvec3 size) {
  const double whole = size.x * size.y * size.z, first = found.range.min, width = found.bin_width();
  const std::vector<double> area = surface_area(found), mean = mean_gradient(found),
                            above = enclosed_volume(found);
  const double largest = *std::ranges::max_element(area);
  for (std::size_t i = 0; i < found.bins(); ++i) {
    const double low = double(i) * width, below = box_below(g, size, low);
    const double within = box_below(g, size, low + width) - below;
    EXPECT_NEAR(above[i], whole - below, 1e-6 * whole) << first + low;
    EXPECT_NEAR(area[i], glm::length(g) * within / width, 1e-4 * largest) << first + low;
    EXPECT_NEAR(mean[i], glm::length(g), 1e-5 * glm::length(g)) << first + low;
  }
}

// Values in float: a difference of two is off by 1e-7 of the range, 2e-5 of a spacing's.
TEST(ByValue, ALinearFieldIsExact) {
  expect_exact_for_linear(measured(make_builtin("linear"), 100), {1, 0.5, 0.25}, glm::dvec3(2));
}

TEST(ByValue, SpacingsMayDiffer) {
  const glm::dvec3 g{0.25, 1, 0.5};
  const Grid grid{{9, 17, 5}, {1, 0.5, 2}, {-3, 7, 1}};
  const Volume volume = volume_of(grid, [&](glm::dvec3 p) { return glm::dot(g, p); });
  expect_exact_for_linear(measured(volume, 37), g, grid.box_size());
}

/// The greatest errors of radius - |x| from its closed forms, relative, over radii of at least 0.2.
struct SphereErrors {
  double area = 0, gradient = 0, volume = 0;
};
SphereErrors sphere_errors(int n) {
  const ByValue found = measured(make_builtin("sphere?n=" + std::to_string(n)), 100);
  const std::vector<double> area = surface_area(found), mean = mean_gradient(found),
                            above = enclosed_volume(found);
  SphereErrors errors;
  for (std::size_t i = 0; i < found.bins(); ++i) {
    const double outer = 1 - (found.range.min + double(i) * found.bin_width()),
                 inner = outer - found.bin_width();
    if (outer > 1 || inner < 0.2) continue;
    const double ball = 4 * pi / 3 * std::pow(outer, 3), hollow = 4 * pi / 3 * std::pow(inner, 3);
    errors.area = std::max(errors.area, std::abs(area[i] * found.bin_width() / (ball - hollow) - 1));
    errors.gradient = std::max(errors.gradient, std::abs(mean[i] - 1));
    errors.volume = std::max(errors.volume, std::abs(above[i] / ball - 1));
  }
  return errors;
}

// The bias that the header states: under 1 % at 6 spacings (0.2 at n = 64), and a quarter at half the
// spacing.
TEST(ByValue, ASphereIsWithinItsBias) {
  const SphereErrors coarse = sphere_errors(64), fine = sphere_errors(127);
  EXPECT_LT(coarse.area, 0.01);
  EXPECT_LT(coarse.gradient, 0.003);
  EXPECT_LT(coarse.volume, 0.01);
  EXPECT_LT(fine.area, 0.35 * coarse.area);
  EXPECT_LT(fine.gradient, 0.35 * coarse.gradient);
  EXPECT_LT(fine.volume, 0.35 * coarse.volume);
}

// Along z the field is linear, so that the space above a value has a closed form but for a sum over x and y.
TEST(ByValue, ATrilinearFieldHasItsVolumes) {
  const FormulaField field = builtin_field("trilinear");
  const ByValue found = measured(make_builtin("trilinear"), 24);
  const std::vector<double> above = enclosed_volume(found);
  constexpr int columns = 400;
  constexpr double side = 2.0 / columns;
  for (std::size_t i = 0; i < found.bins(); ++i) {
    const double value = found.range.min + double(i) * found.bin_width();
    double expected = 0;
    for (int y = 0; y < columns; ++y)
      for (int x = 0; x < columns; ++x) {
        const double px = -1 + side * (x + 0.5), py = -1 + side * (y + 0.5);
        const double bottom = field.value({px, py, -1}) - value, top = field.value({px, py, 1}) - value;
        const double share = bottom >= 0 && top >= 0 ? 1
                             : bottom < 0 && top < 0 ? 0
                                                     : std::max(bottom, top) / std::abs(top - bottom);
        expected += 2 * share * side * side;
      }
    EXPECT_NEAR(above[i], expected, 1e-3) << value;
  }
}

TEST(ByValue, APlateauIsSpaceWithoutGradient) {
  const Grid grid{{6, 3, 3}, glm::dvec3(1), glm::dvec3(0)};
  const ByValue found = measured(volume_of(grid, [](glm::dvec3 p) { return p.x < 2 ? 0 : 4; }), 4);
  // 0 up to x = 1, 4 from x = 2 on, and a ramp between them
  EXPECT_NEAR(found.volume[0], 4 * (1 + 0.25), 1e-12);
  EXPECT_NEAR(found.volume[3], 4 * (3 + 0.25), 1e-12);
  EXPECT_NEAR(found.gradient[0], 4 * 4 * 0.25, 1e-12);
  EXPECT_NEAR(surface_area(found)[2], 4, 1e-12);
}

TEST(ByValue, CellsWithoutAValueDoNotCount) {
  Volume volume = make_builtin("linear?n=9");
  volume.values.floats()[0] = NAN;
  volume.statistics = compute_statistics(volume.grid, volume.values);
  EXPECT_NEAR(sum(measured(volume).volume), 8 - std::pow(0.25, 3), 1e-9);
  const Volume nothing = volume_of({{2, 2, 2}, glm::dvec3(1), glm::dvec3(0)}, [](glm::dvec3) { return NAN; });
  EXPECT_EQ(sum(measured(nothing).volume), 0);
  const Volume flat = volume_of({{2, 2, 2}, glm::dvec3(1), glm::dvec3(0)}, [](glm::dvec3) { return 7; });
  EXPECT_EQ(measured(flat, 3).volume, (std::vector<double>{1, 0, 0}));
  EXPECT_EQ(surface_area(measured(flat, 3)), (std::vector<double>{0, 0, 0}));
}

TEST(ByValue, OfStoredIntegersIsThatOfFloats) {
  Volume volume;
  volume.grid = {{17, 9, 8}, {1, 2, 0.5}, {0, 0, 0}};
  std::vector<std::uint8_t> values(volume.grid.point_count());
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = std::uint8_t(i * i % 251);
  volume.values = Voxels(Voxels::Stored(values), {0.5, -3});
  volume.statistics = compute_statistics(volume.grid, volume.values);
  const ByValue stored = measured(volume, 32);
  EXPECT_NEAR(std::accumulate(stored.volume.begin(), stored.volume.end(), 0.0), 16 * 8 * 7, 1e-9);
  volume.values = volume.values.to_floats();
  const ByValue floats = measured(volume, 32);
  EXPECT_EQ(stored.volume, floats.volume);
  EXPECT_EQ(stored.gradient, floats.gradient);
}

TEST(ByValue, AStopLeavesNothing) {
  std::stop_source source;
  source.request_stop();
  EXPECT_FALSE(measure_by_value(make_builtin("sphere?n=8"), 16, source.get_token()));
}

TEST(SuggestedPeaks, AConstantGradientHasNone) {
  EXPECT_TRUE(suggest_peaks(measured(make_builtin("linear"))).empty());
}

// Three walls at known values: the steeper ones stand out more.
TEST(SuggestedPeaks, AreTheWallsOfAField) {
  const auto wall = [](double x, double at, double steepness) { return std::tanh((x - at) * steepness); };
  const Grid grid{{1025, 2, 2}, glm::dvec3(2.0 / 1024), {-1, 0, 0}};
  const ByValue found = measured(volume_of(grid, [&](glm::dvec3 p) {
    return 0.2 * p.x + wall(p.x, -0.6, 10) + wall(p.x, 0, 20) + wall(p.x, 0.6, 15);
  }));
  const std::vector<SuggestedPeak> peaks = suggest_peaks(found);
  ASSERT_EQ(peaks.size(), 3U);
  const double bin = found.bin_width();
  EXPECT_NEAR(peaks[0].value, 0, 2 * bin);
  EXPECT_NEAR(peaks[1].value, 2 + 0.12, 2 * bin);
  EXPECT_NEAR(peaks[2].value, -2 - 0.12, 2 * bin);
  EXPECT_NEAR(peaks[0].gradient, 20.2, 0.3);
  EXPECT_NEAR(peaks[1].gradient, 15.2, 0.3);
  EXPECT_NEAR(peaks[1].persistence, 15 / 20.2, 0.02);
  EXPECT_NEAR(peaks[2].persistence, 10 / 20.2, 0.02);
}

TEST(SuggestedPeaks, ALessPersistentOneIsLeftOut) {
  ByValue curve{{0, 9}, std::vector<double>(9, 1.0), {0, 0, 9, 9, 1, 1, 6, 6, 0}};
  ASSERT_EQ(suggest_peaks(curve).size(), 2U);
  EXPECT_LT(suggest_peaks(curve)[1].persistence, suggest_peaks(curve)[0].persistence);
  EXPECT_EQ(suggest_peaks(curve, suggest_peaks(curve)[1].persistence + 1e-9).size(), 1U);
}

}  // namespace
}  // namespace crest::test
