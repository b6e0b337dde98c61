#include "render/scene/camera.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "presets/error.h"

namespace crest {
namespace {

bool is_finite(glm::dvec3 v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

CameraFrame frame_of(glm::dvec3 direction, glm::dvec3 up) {
  CameraFrame frame;
  frame.w = glm::normalize(direction);
  glm::dvec3 u = glm::cross(frame.w, up);
  if (!(glm::length(u) > 1e-9 * glm::length(up))) {
    const glm::dvec3 size = glm::abs(frame.w);
    const glm::dvec3 other = size.z <= size.x && size.z <= size.y ? glm::dvec3(0, 0, 1)
                             : size.y <= size.x                   ? glm::dvec3(0, 1, 0)
                                                                  : glm::dvec3(1, 0, 0);
    u = glm::cross(frame.w, other);
  }
  frame.u = glm::normalize(u);
  frame.v = glm::cross(frame.u, frame.w);
  return frame;
}

/// Places in a plane through the line of sight: how far aside, and how far along.
using Corners = std::array<glm::dvec2, 8>;

/// How far an eye has to be before the origin, at the right place beside the line, to see all corners within
/// `slope` on either side. An eye at (c, -d) sees a corner within it where c is no further than slope * (y +
/// d) from x: intervals of c, which have a common point where each two of them have one.
double distance_to_see(const Corners& corners, double slope) {
  double distance = 0;
  for (const glm::dvec2 a : corners)
    for (const glm::dvec2 b : corners) distance = std::max(distance, 0.5 * ((b.x - a.x) / slope - a.y - b.y));
  return distance;
}

/// How far aside an eye `distance` before the origin sees the corners reach as far to one side as to the
/// other: in the middle of the two that need the widest view.
double middle_from(const Corners& corners, double distance) {
  double widest = 0, middle = 0;
  for (const glm::dvec2 a : corners)
    for (const glm::dvec2 b : corners) {
      const double at_a = a.y + distance, at_b = b.y + distance;
      if (const double slope = (b.x - a.x) / (at_a + at_b); slope > widest) {
        widest = slope;
        middle = (a.x * at_b + b.x * at_a) / (at_a + at_b);
      }
    }
  return middle;
}

}  // namespace

Camera whole_volume_camera(const Grid& grid, double aspect, double fov_y_degrees, Projection projection) {
  constexpr double filled = 0.9, least_gap = 1e-3;
  Camera camera;
  camera.up = {0, 0, 1};
  camera.fov_y_degrees = fov_y_degrees;
  const CameraFrame frame = frame_of({-0.45, 0.8, -0.4}, camera.up);
  const glm::dvec3 half = 0.5 * grid.box_size(), middle = grid.origin + half;
  Corners across, upright;
  for (unsigned i = 0; i < 8; ++i) {
    const glm::dvec3 corner = half * glm::dvec3(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
    const double along = glm::dot(corner, frame.w);
    across[i] = {glm::dot(corner, frame.u), along};
    upright[i] = {glm::dot(corner, frame.v), along};
  }
  const double slope = filled * half_height(camera).slope;
  camera.projection = projection;
  if (projection == Projection::parallel) {
    const double height = std::max(std::ranges::max(across, {}, &glm::dvec2::x).x / aspect,
                                   std::ranges::max(upright, {}, &glm::dvec2::x).x);
    camera.target = middle;
    camera.eye = middle - height / slope * frame.w;
    return camera;
  }
  // A view so wide that it holds the box from a corner of it must not begin in that corner
  const double depth = std::ranges::max(across, {}, &glm::dvec2::y).y;
  const double distance = std::max({distance_to_see(across, slope * aspect), distance_to_see(upright, slope),
                                    (1 + 2 * least_gap) * depth});
  camera.target = middle + middle_from(across, distance) * frame.u + middle_from(upright, distance) * frame.v;
  camera.eye = camera.target - distance * frame.w;
  return camera;
}

Camera camera_of(const Preset& preset, const Grid& grid, double aspect) {
  return preset.camera ? *preset.camera : whole_volume_camera(grid, aspect);
}

CameraFrame camera_frame(const Camera& camera) {
  if (!is_finite(camera.eye) || !is_finite(camera.target) || !is_finite(camera.up))
    throw Error("the camera's eye, target and up must be finite numbers");
  const glm::dvec3 view = camera.target - camera.eye;
  if (!(glm::length(view) > 0)) throw Error("the camera's eye and target are the same point");
  return frame_of(view, camera.up);
}

HalfHeight half_height(const Camera& camera) {
  if (!(camera.fov_y_degrees > 0 && camera.fov_y_degrees < 180))
    throw Error(fmt::format("camera.fov_y_degrees: {} is not in (0, 180)", camera.fov_y_degrees));
  if (camera.projection == Projection::parallel) return {half_height_at_target(camera), 0};
  return {0, std::tan(glm::radians(0.5 * camera.fov_y_degrees))};
}

RayFrame ray_frame(const Camera& camera, const Grid& grid, glm::ivec2 image_size) {
  const CameraFrame axes = camera_frame(camera);
  const double unit = grid.smallest_spacing();
  const HalfHeight height = half_height(camera);
  const double aspect = aspect_of(image_size);
  const glm::dvec3 eye = (camera.eye - grid.origin) / unit;
  const glm::dvec3 middle = 0.5 * grid.box_size() / unit;
  const bool is_near = glm::length(middle - eye) <= glm::length(middle);
  const double to_middle = glm::dot(middle - eye, axes.w);
  RayFrame rays;
  rays.w = axes.w;
  rays.u = aspect * height.slope * axes.u;
  rays.v = height.slope * axes.v;
  double at_anchor = height.at_eye / unit;
  if (camera.projection == Projection::parallel) {
    rays.anchor = eye + to_middle * axes.w;
    rays.eye_to_anchor = glm::length(middle);
  } else {
    rays.eye_to_anchor = is_near ? 0 : std::max(0.0, to_middle);
    rays.anchor = eye + rays.eye_to_anchor * axes.w;
    at_anchor = height.slope * rays.eye_to_anchor;
  }
  rays.anchor_u = aspect * at_anchor * axes.u;
  rays.anchor_v = at_anchor * axes.v;
  rays.pixel =
      2 * glm::length(glm::dvec2(aspect, 1) / glm::dvec2(image_size)) * (height.at_eye / unit + height.slope);
  return rays;
}

}  // namespace crest
