#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/glm.hpp>
#include <memory>

#include "render/raycaster/raycaster.h"
#include "render/scene/camera.h"
#include "tests/debug_context.h"

namespace crest::testing {

/// A volume from a formula of the world position.
inline std::shared_ptr<const Volume> make_volume(Grid grid,
                                                 const std::function<double(glm::dvec3)>& formula) {
  Volume volume;
  volume.grid = grid;
  volume.name = "formula";
  for (int k = 0; k < grid.dims.z; ++k)
    for (int j = 0; j < grid.dims.y; ++j)
      for (int i = 0; i < grid.dims.x; ++i)
        volume.values.floats().push_back(float(formula(grid.origin + grid.spacing * glm::dvec3(i, j, k))));
  volume.statistics = compute_statistics(volume.grid, volume.values);
  return std::make_shared<const Volume>(std::move(volume));
}

inline ControlPoint point(double value, double opacity, glm::dvec3 color = glm::dvec3(1)) {
  ControlPoint p;
  p.value = value;
  p.opacity = opacity;
  p.color = color;
  return p;
}

/// A resolved TF of these points.
inline TransferFunction make_tf(std::vector<ControlPoint> points, double unit_distance = 1) {
  TransferFunction tf;
  tf.points = std::move(points);
  tf.unit_distance = unit_distance;
  return tf;
}

/// Looks along +z at the middle of a unit-spaced box, from so far that all rays are parallel in effect; a
/// pixel's side is `extent` / `pixels` in world units.
inline Camera along_z(const Grid& grid, double extent) {
  Camera camera;
  const glm::dvec3 middle = grid.origin + 0.5 * grid.box_size();
  const double distance = 1e5 * extent;
  camera.target = middle;
  camera.eye = middle - glm::dvec3(0, 0, distance);
  camera.up = {0, 1, 0};
  camera.fov_y_degrees = glm::degrees(2 * std::atan(0.5 * extent / distance));
  return camera;
}

/// Sees the whole box of the built-in volumes, from -1 to 1, in a square picture: of its own, so that what is
/// kept or was measured in it does not depend on how a view is fitted.
inline const Camera sees_unit_cube{{2.9297745775126893, -5.2084881378003365, 2.6042440689001682},
                                   {0, 0, 0},
                                   {0, 0, 1},
                                   30,
                                   Projection::perspective,
                                   {}};

/// Of two pictures of one size, in any channel of any pixel.
inline double largest_difference(const Image& a, const Image& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i)
    for (int channel = 0; channel < 4; ++channel)
      largest = std::max(largest, double(std::abs(a.pixels[i][channel] - b.pixels[i][channel])));
  return largest;
}

/// One context and one ray caster for all tests of a suite: what was drawn before must not matter.
class RaycasterTest : public ::testing::Test {
 protected:
  static void SetUpTestSuite() { gpu_ = std::make_unique<Gpu>(); }
  static void TearDownTestSuite() { gpu_.reset(); }
  ~RaycasterTest() override { raycaster.force({}); }

  Image render(const Scene& scene, const Camera& camera, glm::ivec2 size = {16, 16}) {
    gl::RenderTarget target(size, false);
    raycaster.draw(scene, camera, target);
    return target.read_color();
  }
  RenderCounts count(const Scene& scene, const Camera& camera, glm::ivec2 size = {16, 16}) {
    gl::RenderTarget target(size, true);
    return raycaster.draw_counted(scene, camera, target);
  }

 private:
  struct Gpu {
    DebugContext context;
    Raycaster raycaster;
  };
  static inline std::unique_ptr<Gpu> gpu_;

 protected:
  OffscreenContext& context = gpu_->context;
  Raycaster& raycaster = gpu_->raycaster;
};

}  // namespace crest::testing
