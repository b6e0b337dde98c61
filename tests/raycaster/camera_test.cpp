#include "render/scene/camera.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

#include "render/scene/view.h"
#include "render/volume/random.h"

namespace crest {
namespace {

/// Where the box's corners lie in a picture of this aspect, each side of which is at -1 or 1.
struct SeenBox {
  glm::dvec2 low{INFINITY}, high{-INFINITY};
  double nearest = INFINITY, farthest = 0;  ///< along the line of sight
  glm::dvec2 extent() const { return high - low; }
};

SeenBox seen_box(const Grid& grid, const Camera& camera, double aspect) {
  const CameraFrame frame = camera_frame(camera);
  SeenBox seen;
  for (unsigned i = 0; i < 8; ++i) {
    const glm::dvec3 share(i & 1, i >> 1 & 1, i >> 2 & 1);
    const glm::dvec3 p = grid.origin + share * grid.box_size() - camera.eye;
    const double depth = glm::dot(p, frame.w);
    if (camera.projection == Projection::perspective) {
      EXPECT_GT(depth, 0) << "behind the eye";
    }
    seen.nearest = std::min(seen.nearest, depth);
    seen.farthest = std::max(seen.farthest, depth);
    const double height = half_height(camera)(depth);
    const glm::dvec2 place(glm::dot(p, frame.u) / (height * aspect), glm::dot(p, frame.v) / height);
    seen.low = glm::min(seen.low, place);
    seen.high = glm::max(seen.high, place);
  }
  return seen;
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
    const SeenBox seen = seen_box(grid, camera, aspect);
    const SeenBox parallel =
        seen_box(grid, whole_volume_camera(grid, aspect, fov, Projection::parallel), aspect);
    EXPECT_NEAR(std::max(parallel.high.x, parallel.high.y), 0.9, 1e-6);
    EXPECT_NEAR(parallel.low.x + parallel.high.x, 0, 1e-6);
    EXPECT_NEAR(parallel.low.y + parallel.high.y, 0, 1e-6);
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

constexpr Grid odd_box{{8, 9, 10}, {1, 2, 0.5}, {3, 4, 5}};

// Every ray runs along the view and begins before the box, also where the eye is in it; pixels lie equally
// far apart, as far as in perspective at the target.
TEST(ParallelRays, DependOnTheViewsHeightAlone) {
  Camera camera = whole_volume_camera(odd_box, 1.5);
  camera.projection = Projection::parallel;
  const RayFrame rays = ray_frame(camera, odd_box, {300, 200});
  EXPECT_EQ(rays.u, glm::dvec3(0));
  EXPECT_EQ(rays.v, glm::dvec3(0));
  const double unit = odd_box.smallest_spacing(), distance = glm::length(camera.target - camera.eye);
  EXPECT_NEAR(glm::length(rays.anchor_v) * unit, distance * std::tan(glm::radians(15.0)), 1e-9);
  EXPECT_NEAR(glm::length(rays.anchor_u), 1.5 * glm::length(rays.anchor_v), 1e-9);
  EXPECT_NEAR(rays.pixel, std::sqrt(2.0) * glm::length(rays.anchor_v) / 100, 1e-9);

  Camera near = camera;  // a tenth of the distance, ten times the height at distance 1
  near.eye = glm::mix(camera.target, camera.eye, 0.1);
  near.fov_y_degrees = glm::degrees(2 * std::atan(10 * std::tan(glm::radians(15.0))));
  const RayFrame same = ray_frame(near, odd_box, {300, 200});
  EXPECT_NEAR(glm::length(same.anchor - rays.anchor), 0, 1e-9);
  EXPECT_NEAR(glm::length(same.anchor_v - rays.anchor_v), 0, 1e-9);
  EXPECT_EQ(same.eye_to_anchor, rays.eye_to_anchor);
  for (unsigned i = 0; i < 8; ++i) {
    const glm::dvec3 corner =
        glm::dvec3(i & 1, i >> 1 & 1, i >> 2 & 1) * odd_box.box_size() / odd_box.smallest_spacing();
    EXPECT_GE(glm::dot(corner - rays.anchor, rays.w), -rays.eye_to_anchor);
  }
}

// There and back: the same camera; and a place in the target's plane stays in its pixel.
TEST(ParallelRays, KeepTheTargetsPlane) {
  const Camera camera = whole_volume_camera(odd_box, 1.5, 50);
  Camera parallel = camera;
  parallel.projection = Projection::parallel;
  const RayFrame there = ray_frame(camera, odd_box, {300, 200}),
                 rays = ray_frame(parallel, odd_box, {300, 200});
  const glm::dvec3 target = (camera.target - odd_box.origin) / odd_box.smallest_spacing();
  for (const glm::dvec2 place : {glm::dvec2(0, 0), {1, 1}, {-0.3, 0.8}}) {
    const auto in_plane = [&](const RayFrame& frame) {
      const glm::dvec3 origin = frame.anchor + place.x * frame.anchor_u + place.y * frame.anchor_v;
      const glm::dvec3 direction = frame.w + place.x * frame.u + place.y * frame.v;
      return origin + glm::dot(target - origin, frame.w) * direction;
    };
    EXPECT_NEAR(glm::length(in_plane(there) - in_plane(rays)), 0, 1e-9) << place.x << ", " << place.y;
  }
}

// No ray is longer than the bound says, and one that says so is there; what lies beside the view or behind
// the eye.
TEST(ParallelRays, AreAsLongAsTheBoxIsAlongThem) {
  const Box box{{0, 0, 0}, {4, 3, 2}};
  Camera camera{.eye = {-9, 1, 1}, .target = {1, 1, 1}, .up = {0, 0, 1}, .unknown = {}};
  camera.projection = Projection::parallel;
  EXPECT_DOUBLE_EQ(longest_ray(camera, box), 4);
  camera.target = camera.eye + glm::dvec3(1, 1, 0);
  EXPECT_NEAR(longest_ray(camera, box), 3 * std::sqrt(2.0), 1e-12) << "from one long side to the other";
  camera.target = camera.eye + glm::dvec3(4, 3, 2);
  EXPECT_NEAR(longest_ray(camera, box), std::sqrt(29.0), 1e-12);

  camera.target = {1, 1, 1};
  EXPECT_TRUE(may_see(camera, 1, box));
  camera.target = camera.eye - glm::dvec3(10, 0, 0);
  EXPECT_TRUE(may_see(camera, 1, box)) << "rays begin before it, wherever the eye is";
  const double half = half_height_at_target(camera);
  for (const double off : {-1.01, -0.99, 0.99, 1.01}) {
    Camera beside = camera;
    beside.eye.z = beside.target.z = (off < 0 ? 0 : 2) + off * half;
    EXPECT_EQ(may_see(beside, 1, box), std::abs(off) < 1) << off;
  }
}

}  // namespace
}  // namespace crest
