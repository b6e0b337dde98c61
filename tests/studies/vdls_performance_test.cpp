#include "render/studies/vdls/performance.h"

#include <gtest/gtest.h>

#include <cmath>

#include "render/studies/vdls/scenes.h"
#include "render/volume/builtin.h"

namespace crest {
namespace {

VdlsSeries series_of(double (*time)(double x)) {
  VdlsSeries series;
  for (const double x : {1.0, 2.0, 4.0, 8.0}) series.points.push_back({x, "", {{"", {time(x)}, 0}}});
  return series;
}

TEST(VdlsFit, TellsProportionalFromLinearFromNeither) {
  const LineFit line = fit_line(series_of([](double x) { return 3 + 2 * x; }), 0, 1);
  EXPECT_NEAR(line.fixed_ms, 3, 1e-9);
  EXPECT_NEAR(line.ms_per_unit, 2, 1e-9);
  EXPECT_NEAR(line.fixed_share, 3.0 / 19, 1e-9);
  EXPECT_LT(line.largest_residual, 1e-9);
  EXPECT_EQ(growth_of(line), Growth::linear);
  EXPECT_EQ(growth_of(fit_line(series_of([](double x) { return 0.5 + 2 * x; }), 0, 1)), Growth::proportional);
  const auto cubic = [](double x) { return x * x * x; };
  EXPECT_EQ(growth_of(fit_line(series_of(cubic), 0, 1)), Growth::other);
  EXPECT_EQ(growth_of(fit_line(series_of(cubic), 0, 3)), Growth::proportional);
  EXPECT_EQ(growth_of(fit_line(series_of([](double) { return 5.0; }), 0, 1)), Growth::other);
}

// The paper's "random rotation", the same each time: all around, at one distance.
TEST(VdlsViews, AreSeededAndAllAround) {
  const Grid grid = make_builtin("sphere?n=8").grid;
  const auto views = random_views(grid, 100, 7), again = random_views(grid, 100, 7);
  const double distance = glm::length(views[0].eye - views[0].target);
  glm::dvec3 sum(0);
  for (std::size_t i = 0; i < views.size(); ++i) {
    EXPECT_EQ(views[i].eye, again[i].eye);
    EXPECT_NEAR(glm::length(views[i].eye - views[i].target), distance, 1e-9 * distance);
    sum += (views[i].eye - views[i].target) / distance;
  }
  EXPECT_NE(views[0].eye, random_views(grid, 1, 8)[0].eye);
  EXPECT_LT(glm::length(sum) / double(views.size()), 0.25);  // uniform ones: 0.1
}

}  // namespace
}  // namespace crest
