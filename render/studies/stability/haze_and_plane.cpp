#include "render/studies/stability/haze_and_plane.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <limits>

#include "presets/choices.h"
#include "render/scene/camera.h"

namespace crest::stability {
namespace {

const glm::dvec3 haze_color(0, 0, 1), surface_color(1, 0, 0);

/// A ray's part in the box: empty where exit < enter.
struct RayInBox {
  glm::dvec3 eye, direction;
  double enter = 0, exit = std::numeric_limits<double>::max();
};

RayInBox ray_in_box(const Camera& camera, const Grid& grid, glm::ivec2 size, int x, int y) {
  const CameraFrame frame = camera_frame(camera);
  const double half = std::tan(glm::radians(0.5 * camera.fov_y_degrees));
  const double right = (2 * (x + 0.5) / size.x - 1) * half * size.x / size.y;
  const double above = (1 - 2 * (y + 0.5) / size.y) * half;
  RayInBox ray;
  ray.eye = camera.eye;
  ray.direction = glm::normalize(frame.w + right * frame.u + above * frame.v);
  for (int axis = 0; axis < 3; ++axis) {
    const double low = grid.box_min()[axis] - ray.eye[axis], high = grid.box_max()[axis] - ray.eye[axis];
    const double along = ray.direction[axis];
    if (along == 0) {
      if (low > 0 || high < 0) ray.exit = -1;
      continue;
    }
    ray.enter = std::max(ray.enter, std::min(low / along, high / along));
    ray.exit = std::min(ray.exit, std::max(low / along, high / along));
  }
  return ray;
}

double field_at(const HazeAndPlane& haze, glm::dvec3 position) {
  return glm::dot(glm::dvec3(haze.weights), (position - haze.grid.origin) / haze.grid.spacing);
}

/// Premultiplied, one behind the other.
struct Layers {
  glm::dvec4 collected{0};
  void add(glm::dvec3 color, double opacity) {
    collected += (1 - collected.a) * opacity * glm::dvec4(color, 1);
  }
};

glm::dvec4 pixel_of(const HazeAndPlane& haze, Mode mode, const RayInBox& ray) {
  Layers layers;
  if (ray.exit < ray.enter) return layers.collected;
  const double size = ray.exit - ray.enter, isovalue = haze.isovalue();
  const double first = field_at(haze, ray.eye + ray.enter * ray.direction);
  const double last = field_at(haze, ray.eye + ray.exit * ray.direction);
  const bool crossed = shows_surfaces(mode) && (first < isovalue) != (last < isovalue);
  const double before = crossed ? size * (isovalue - first) / (last - first) : size;
  const auto add_haze = [&](double length) {
    if (shows_dvr(mode))
      layers.add(haze_color, -std::expm1(std::log1p(-haze.haze_opacity) * length / haze.unit_distance));
  };
  add_haze(before);
  if (crossed) layers.add(surface_color, haze.surface_opacity);
  add_haze(size - before);
  return layers.collected;
}

template <class Result>
std::vector<Result> of_pixels(const HazeAndPlane& haze, const Camera& camera, glm::ivec2 size,
                              auto&& of_ray) {
  std::vector<Result> results;
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x) results.push_back(of_ray(ray_in_box(camera, haze.grid, size, x, y)));
  return results;
}

}  // namespace

double HazeAndPlane::isovalue() const {
  return isovalue_share * glm::dot(glm::dvec3(weights), glm::dvec3(grid.dims - 1));
}

Scene scene_of(const HazeAndPlane& haze, Mode mode, double step) {
  std::vector<float> values;
  for (int k = 0; k < haze.grid.dims.z; ++k)
    for (int j = 0; j < haze.grid.dims.y; ++j)
      for (int i = 0; i < haze.grid.dims.x; ++i)
        values.push_back(float(haze.weights.x * i + haze.weights.y * j + haze.weights.z * k));
  VolumePtr volume = make_volume(haze.grid, std::move(values));
  TransferFunction tf = haze_with_surface(volume->statistics.range, haze.isovalue(), haze.haze_opacity,
                                          haze.surface_opacity, haze.unit_distance, mode);
  return make_scene(std::move(volume), std::move(tf), mode, step);
}

std::vector<glm::dvec4> truth_of(const HazeAndPlane& haze, Mode mode, const Camera& camera, glm::ivec2 size) {
  return of_pixels<glm::dvec4>(haze, camera, size,
                               [&](const RayInBox& ray) { return pixel_of(haze, mode, ray); });
}

std::vector<bool> surface_at_an_end(const HazeAndPlane& haze, const Camera& camera, glm::ivec2 size) {
  const glm::dvec3 slope = glm::dvec3(haze.weights) / haze.grid.spacing;
  const double rounding = 0x1p-22 * glm::length(haze.grid.box_size()) * (slope.x + slope.y + slope.z);
  return of_pixels<bool>(haze, camera, size, [&](const RayInBox& ray) {
    const auto is_at = [&](double t) {
      return std::abs(field_at(haze, ray.eye + t * ray.direction) - haze.isovalue()) <= rounding;
    };
    return is_at(ray.enter) || is_at(ray.exit);
  });
}

}  // namespace crest::stability
