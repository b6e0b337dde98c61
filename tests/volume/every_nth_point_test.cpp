#include "render/volume/every_nth_point.h"

#include <gtest/gtest.h>

#include <cmath>

#include "presets/error.h"
#include "render/volume/take_part.h"

namespace crest::test {
namespace {

/// A ball of value 100, smooth over a spacing or two, and around it rods of value 50 that are one point
/// thick.
Volume ball_and_rods() {
  constexpr int n = 65;
  Volume volume;
  volume.grid = {glm::ivec3(n), glm::dvec3(1), glm::dvec3(-32)};
  std::vector<float>& values = volume.values.floats();
  for (int k = 0; k < n; ++k)
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i) {
        const double r = std::hypot(i - 32, j - 32, k - 32);
        const bool rod = r > 26 && i % 4 == 1 && j % 4 == 1;
        values.push_back(rod ? -50.F : 100 * float(1 / (1 + std::exp((r - 16) / 2))));
      }
  volume.statistics = compute_statistics(volume.grid, volume.values);
  return volume;
}

TEST(EveryNthPoint, SmoothSurfacesStayAndThinOnesAreLost) {
  const Volume volume = ball_and_rods();
  const auto left = surface_left(volume, 2, {50, -25, 1000});
  ASSERT_TRUE(left[0] && left[1]);
  EXPECT_NEAR(*left[0], 1, 0.03);
  EXPECT_EQ(*left[1], 0);  // no rod goes through a point with even indices
  EXPECT_FALSE(left[2]);
}

TEST(EveryNthPoint, PointsStayWhereTheyAre) {
  const Volume volume = ball_and_rods(), thin = every_nth_point(volume, 3);
  EXPECT_EQ(thin.grid.dims, glm::ivec3(22));
  EXPECT_EQ(thin.at(4, 5, 6), volume.at(12, 15, 18));
  EXPECT_EQ(thin.grid.origin, volume.grid.origin);
  EXPECT_EQ(full_grid(thin), volume.grid);
  EXPECT_THROW(every_nth_point(volume, 65), Error);
}

}  // namespace
}  // namespace crest::test
