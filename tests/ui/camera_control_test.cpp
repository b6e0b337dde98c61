#include "ui/camera_control.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "render/scene/camera.h"

namespace crest {
namespace {

constexpr double pi = std::numbers::pi;

Camera test_camera() { return {{10, 2, 3}, {1, 2, 3}, {0, 0, 1}, 40, Projection::perspective, {}}; }

void expect_near(glm::dvec3 a, glm::dvec3 b, double bound) { EXPECT_LT(glm::length(a - b), bound); }

TEST(Orbit, QuarterTurnGoesAroundTheUpAxis) {
  const Camera turned = orbit(test_camera(), pi / 2, 0);
  expect_near(turned.eye, {1, 11, 3}, 1e-12);
  expect_near(turned.target, test_camera().target, 0.0 + 1e-15);
}

TEST(Orbit, KeepsTheDistanceAndComesBack) {
  Camera camera = test_camera();
  for (int i = 0; i < 100; ++i) camera = orbit(camera, 0.07, 0.01);
  EXPECT_NEAR(glm::length(camera.eye - camera.target), 9, 1e-10);
  for (int i = 0; i < 100; ++i) camera = orbit(camera, -0.07, -0.01);
  expect_near(camera.eye, test_camera().eye, 1e-9);
}

TEST(Orbit, StopsShortOfThePolesAndCanLeaveThem) {
  Camera camera = test_camera();
  for (int i = 0; i < 50; ++i) camera = orbit(camera, 0.1, 1);
  const glm::dvec3 to_eye = glm::normalize(camera.eye - camera.target);
  EXPECT_GT(to_eye.z, 0.999);
  EXPECT_LT(to_eye.z, 1);
  EXPECT_NO_THROW(camera_frame(camera));
  const Camera left = orbit(camera, 0, -1);
  EXPECT_NEAR(std::asin(glm::normalize(left.eye - left.target).z), pi / 2 - 0.01 - 1, 1e-9);
}

TEST(Orbit, AnUpAlongTheViewIsNoTrap) {
  const Camera turned = orbit({{0, 0, 5}, {0, 0, 0}, {0, 0, 1}, 30, Projection::perspective, {}}, 0.3, -0.5);
  EXPECT_NEAR(glm::length(turned.eye), 5, 1e-9);
  EXPECT_NEAR(std::acos(turned.eye.z / 5), 0.5, 1e-9);
  const Camera none = orbit({{0, 0, 5}, {0, 0, 0}, {0, 0, 0}, 30, Projection::perspective, {}}, 0.3, 0.1);
  EXPECT_TRUE(std::isfinite(none.eye.x + none.eye.y + none.eye.z));
}

TEST(Pan, MovesThePictureByItsShareOfTheHeight) {
  const Camera camera = test_camera();
  const Camera panned = pan(camera, {0.25, -0.5});
  // The old target appears where the mouse took it: 0.25 of the height to the right, 0.5 down.
  const auto ends = project_segment(panned, 1, camera.target, camera.target);
  ASSERT_TRUE(ends);
  EXPECT_NEAR(ends->first.x, 0.5, 1e-12);
  EXPECT_NEAR(ends->first.y, -1, 1e-12);
  expect_near(panned.eye - panned.target, camera.eye - camera.target, 1e-12);
}

TEST(Dolly, ScalesTheDistanceWithinItsBounds) {
  const Camera camera = test_camera();
  EXPECT_NEAR(glm::length(dolly(camera, 0.5, 1, 100).eye - camera.target), 4.5, 1e-12);
  EXPECT_NEAR(glm::length(dolly(camera, 1e-9, 1, 100).eye - camera.target), 1, 1e-12);
  EXPECT_NEAR(glm::length(dolly(camera, 1e9, 1, 100).eye - camera.target), 100, 1e-10);
}

TEST(ProjectSegment, AgreesWithTheRaysOfThePicture) {
  const Camera camera = test_camera();
  const CameraFrame frame = camera_frame(camera);
  const double half = std::tan(camera.fov_y_degrees * pi / 360), aspect = 1.5;
  const glm::dvec3 point =
      camera.eye + 7.0 * (frame.w + 0.3 * half * aspect * frame.u - 0.6 * half * frame.v);
  const auto ends = project_segment(camera, aspect, point, point);
  ASSERT_TRUE(ends);
  EXPECT_NEAR(ends->first.x, 0.3, 1e-12);
  EXPECT_NEAR(ends->first.y, -0.6, 1e-12);
}

// Edges of a box that are parallel stay so and as long, also behind the eye; a place is where its ray is.
TEST(ProjectSegment, KeepsParallelEdgesParallel) {
  const Camera camera = with_other_projection(test_camera());
  const CameraFrame frame = camera_frame(camera);
  const double half = half_height_at_target(camera), aspect = 1.5;
  const glm::dvec3 edge(-3, 1, 2);
  const auto one = project_segment(camera, aspect, {0, 0, 0}, edge);
  const auto other = project_segment(camera, aspect, glm::dvec3(30, 5, -7), glm::dvec3(30, 5, -7) + edge);
  ASSERT_TRUE(one && other);
  EXPECT_NEAR(glm::length((one->second - one->first) - (other->second - other->first)), 0, 1e-12);
  for (const double depth : {-20.0, 0.0, 9.0, 40.0}) {
    const glm::dvec3 point =
        camera.eye + depth * frame.w + 0.3 * half * aspect * frame.u - 0.6 * half * frame.v;
    const auto ends = project_segment(camera, aspect, point, point);
    ASSERT_TRUE(ends);
    EXPECT_NEAR(ends->first.x, 0.3, 1e-12);
    EXPECT_NEAR(ends->first.y, -0.6, 1e-12);
  }
}

TEST(CameraControl, ProjectionsKeepTheTargetsPlane) {
  const Camera camera = test_camera(), parallel = with_other_projection(camera);
  EXPECT_EQ(parallel.projection, Projection::parallel);
  EXPECT_EQ(with_other_projection(parallel), camera);
  const CameraFrame frame = camera_frame(camera);
  const glm::dvec3 from = camera.target + 0.7 * frame.u, to = camera.target - 0.4 * frame.v;
  const auto there = project_segment(camera, 2, from, to), here = project_segment(parallel, 2, from, to);
  ASSERT_TRUE(there && here);
  EXPECT_NEAR(glm::length(there->first - here->first), 0, 1e-12);
  EXPECT_NEAR(glm::length(there->second - here->second), 0, 1e-12);
  const auto nearer = project_segment(dolly(parallel, 0.5, 1, 100), 2, from, to);
  EXPECT_NEAR(nearer->first.x, 2 * here->first.x, 1e-12) << "half the distance is twice the size";
}

TEST(ProjectSegment, CutsWhatIsBehindTheEye) {
  const Camera camera{{0, 0, 0}, {0, 0, 1}, {0, 1, 0}, 90, Projection::perspective, {}};
  EXPECT_FALSE(project_segment(camera, 1, {0, 0, -1}, {1, 0, -5}));
  const auto ends = project_segment(camera, 1, {0.5, 0, 1}, {0.5, 0, -1});
  ASSERT_TRUE(ends);
  EXPECT_NEAR(std::abs(ends->first.x), 0.5, 1e-12);
  EXPECT_TRUE(std::isfinite(ends->second.x));
}

TEST(CameraControl, LooksAlongAnAxisAtTheSameTarget) {
  const Camera before{.eye = {3, 4, 5}, .target = {1, 1, 1}, .up = {0, 0, 1}, .unknown = {}};
  for (const glm::dvec3 direction : {glm::dvec3(1, 0, 0), glm::dvec3(0, -1, 0), glm::dvec3(0, 0, 1)}) {
    const Camera camera = look_along(before, direction);
    EXPECT_EQ(camera.target, before.target);
    EXPECT_NEAR(glm::length(camera.target - camera.eye - direction * glm::length(before.target - before.eye)),
                0, 1e-12);
    EXPECT_EQ(glm::dot(camera.up, direction), 0) << "up lies across";
  }
}

TEST(CameraControl, FourQuarterTurnsAreNone) {
  const Camera before =
      look_along({.eye = {3, 4, 5}, .target = {1, 1, 1}, .up = {0, 0, 1}, .unknown = {}}, {0, 1, 0});
  Camera camera = roll(before, std::acos(-1.0) / 2);
  EXPECT_NEAR(glm::length(camera.up - glm::dvec3(-1, 0, 0)), 0, 1e-12)
      << "the top of the picture goes to the right";
  for (int i = 0; i < 3; ++i) camera = roll(camera, std::acos(-1.0) / 2);
  EXPECT_NEAR(glm::length(camera.up - before.up), 0, 1e-12);
  EXPECT_EQ(camera.eye, before.eye);
}

}  // namespace
}  // namespace crest
