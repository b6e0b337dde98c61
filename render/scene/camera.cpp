#include "render/scene/camera.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "presets/error.h"

namespace crest {
namespace {

bool is_finite(glm::dvec3 v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

}  // namespace

// The nearest eye on its line from which each corner of the box is within the view, with a margin.
Camera whole_volume_camera(const Grid& grid, double fov_y_degrees) {
  constexpr double margin = 1.04;
  const glm::dvec3 half = 0.5 * grid.box_size();
  Camera camera;
  camera.target = grid.origin + half;
  camera.eye = camera.target + glm::dvec3(0.45, -0.8, 0.4);
  camera.up = {0, 0, 1};
  camera.fov_y_degrees = fov_y_degrees;
  const CameraFrame frame = camera_frame(camera);
  const double slope = std::tan(glm::radians(0.5 * fov_y_degrees));
  double distance = 0;
  for (int corner = 0; corner < 8; ++corner) {
    const glm::dvec3 p = half * glm::dvec3(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
    const double aside = std::max(std::abs(glm::dot(p, frame.u)), std::abs(glm::dot(p, frame.v)));
    distance = std::max(distance, margin * aside / slope - glm::dot(p, frame.w));
  }
  camera.eye = camera.target - distance * frame.w;
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

double half_height(const Camera& camera) {
  if (!(camera.fov_y_degrees > 0 && camera.fov_y_degrees < 180))
    throw Error(fmt::format("camera.fov_y_degrees: {} is not in (0, 180)", camera.fov_y_degrees));
  return std::tan(glm::radians(0.5 * camera.fov_y_degrees));
}

RayFrame ray_frame(const Camera& camera, const Grid& grid, glm::ivec2 image_size) {
  const CameraFrame axes = camera_frame(camera);
  const double unit = grid.smallest_spacing();
  const double height = half_height(camera), width = height * double(image_size.x) / double(image_size.y);
  const glm::dvec3 eye = (camera.eye - grid.origin) / unit;
  const glm::dvec3 middle = 0.5 * grid.box_size() / unit;
  RayFrame rays;
  rays.w = axes.w;
  rays.u = width * axes.u;
  rays.v = height * axes.v;
  const bool is_near = glm::length(middle - eye) <= glm::length(middle);
  rays.eye_to_anchor = is_near ? 0 : std::max(0.0, glm::dot(middle - eye, axes.w));
  rays.anchor = eye + rays.eye_to_anchor * axes.w;
  rays.anchor_u = rays.eye_to_anchor * rays.u;
  rays.anchor_v = rays.eye_to_anchor * rays.v;
  return rays;
}

}  // namespace crest
