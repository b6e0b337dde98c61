#include "render/camera.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "presets/error.h"

namespace crest {
namespace {

bool is_finite(glm::dvec3 v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

}  // namespace

Camera whole_volume_camera(const Grid& grid, double fov_y_degrees) {
  const glm::dvec3 middle = grid.origin + 0.5 * grid.box_size();
  const double radius = 0.5 * glm::length(grid.box_size());
  const double distance = radius / std::sin(glm::radians(0.5 * fov_y_degrees));
  Camera camera;
  camera.eye = middle + distance * glm::normalize(glm::dvec3(0.45, -0.8, 0.4));
  camera.target = middle;
  camera.up = {0, 0, 1};
  camera.fov_y_degrees = fov_y_degrees;
  return camera;
}

CameraFrame camera_frame(const Camera& camera) {
  if (!is_finite(camera.eye) || !is_finite(camera.target) || !is_finite(camera.up))
    throw Error("the camera's eye, target and up must be finite numbers");
  const glm::dvec3 view = camera.target - camera.eye;
  if (!(glm::length(view) > 0)) throw Error("the camera's eye and target are the same point");
  CameraFrame frame;
  frame.w = glm::normalize(view);
  glm::dvec3 u = glm::cross(frame.w, camera.up);
  if (!(glm::length(u) > 1e-9 * glm::length(camera.up))) {
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

RayFrame ray_frame(const Camera& camera, const Grid& grid, glm::ivec2 image_size) {
  if (!(camera.fov_y_degrees > 0 && camera.fov_y_degrees < 180))
    throw Error(fmt::format("camera.fov_y_degrees: {} is not in (0, 180)", camera.fov_y_degrees));
  const CameraFrame axes = camera_frame(camera);
  const double unit = grid.smallest_spacing();
  const double half_height = std::tan(glm::radians(0.5 * camera.fov_y_degrees));
  const double half_width = half_height * double(image_size.x) / double(image_size.y);
  const glm::dvec3 eye = (camera.eye - grid.origin) / unit;
  const glm::dvec3 middle = 0.5 * grid.box_size() / unit;
  RayFrame rays;
  rays.w = axes.w;
  rays.u = half_width * axes.u;
  rays.v = half_height * axes.v;
  rays.eye_to_anchor = std::max(0.0, glm::dot(middle - eye, axes.w));
  rays.anchor = eye + rays.eye_to_anchor * axes.w;
  rays.anchor_u = rays.eye_to_anchor * rays.u;
  rays.anchor_v = rays.eye_to_anchor * rays.v;
  return rays;
}

}  // namespace crest
