#include "render/scene/camera.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

#include "render/volume/random.h"

namespace crest {
namespace {

/// Where the box's corners lie in a picture of this aspect, each side of which is at -1 or 1.
struct Projection {
  glm::dvec2 low{INFINITY}, high{-INFINITY};
  double nearest = INFINITY, farthest = 0;  ///< along the line of sight
  glm::dvec2 extent() const { return high - low; }
};

Projection projection_of(const Grid& grid, const Camera& camera, double aspect) {
  const CameraFrame frame = camera_frame(camera);
  const double height = half_height(camera);
  Projection projection;
  for (unsigned i = 0; i < 8; ++i) {
    const glm::dvec3 share(i & 1, i >> 1 & 1, i >> 2 & 1);
    const glm::dvec3 p = grid.origin + share * grid.box_size() - camera.eye;
    const double depth = glm::dot(p, frame.w);
    EXPECT_GT(depth, 0) << "behind the eye";
    projection.nearest = std::min(projection.nearest, depth);
    projection.farthest = std::max(projection.farthest, depth);
    const glm::dvec2 place(glm::dot(p, frame.u) / (height * aspect * depth),
                           glm::dot(p, frame.v) / (height * depth));
    projection.low = glm::min(projection.low, place);
    projection.high = glm::max(projection.high, place);
  }
  return projection;
}

double power_of_ten(Random& random, double low, double high) {
  return std::pow(10, random.uniform(low, high));
}

TEST(WholeVolumeCamera, FillsNineTenthsOfThePicture) {
  Random random(11);
  int filled = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    const double unit = power_of_ten(random, -15, 15);
    Grid grid;
    for (int axis = 0; axis < 3; ++axis) {
      grid.dims[axis] = int(power_of_ten(random, 0.31, 3));
      grid.spacing[axis] = unit * power_of_ten(random, -1, 1);
    }
    for (int axis = 0; axis < 3; ++axis)
      grid.origin[axis] = random.uniform(-10, 10) * glm::length(grid.box_size());
    const double aspect = power_of_ten(random, std::log10(0.2), std::log10(5));
    const double fov = trial % 2 ? 30 : random.uniform(1, 150);
    const Camera camera = whole_volume_camera(grid, aspect, fov);
    const Projection seen = projection_of(grid, camera, aspect);
    SCOPED_TRACE(testing::Message() << trial << ": aspect " << aspect << ", fov " << fov << ", unit "
                                    << unit);
    const double tighter = std::max(seen.extent().x, seen.extent().y);
    EXPECT_LE(tighter, 2 * 0.9 + 1e-6);
    // From less than a thousandth before the box no more can be had
    if (seen.nearest > 1.01e-3 * (seen.farthest - seen.nearest)) {
      EXPECT_NEAR(tighter, 2 * 0.9, 1e-6);
      ++filled;
    }
    // In the middle, in both directions
    EXPECT_NEAR(seen.low.x + seen.high.x, 0, 1e-6);
    EXPECT_NEAR(seen.low.y + seen.high.y, 0, 1e-6);
    EXPECT_EQ(camera.fov_y_degrees, fov);
  }
  EXPECT_GT(filled, 1700);
}

TEST(WholeVolumeCamera, LooksTheSameWayInEveryUnit) {
  const Grid plain{{8, 9, 10}, {1, 2, 0.5}, {3, 4, 5}};
  const Camera one = whole_volume_camera(plain, 1.5);
  for (const double unit : {1e-15, 1e14, 1e15}) {
    const Camera other = whole_volume_camera({plain.dims, plain.spacing * unit, plain.origin * unit}, 1.5);
    EXPECT_LT(glm::length(other.eye / unit - one.eye), 1e-12 * glm::length(one.eye)) << unit;
    EXPECT_LT(glm::length(other.target / unit - one.target), 1e-12 * glm::length(one.eye)) << unit;
  }
}

}  // namespace
}  // namespace crest
