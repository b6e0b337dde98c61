#include "ui/camera_control.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>

#include "render/scene/camera.h"

namespace crest {
namespace {

constexpr double pole_margin = 0.01;  // radians

/// Unit vectors of the view. They exist for every camera: a missing or parallel up is replaced.
struct Basis {
  glm::dvec3 right, up, forward, turntable_up;
  double distance;
};

glm::dvec3 any_perpendicular(glm::dvec3 v) {
  const glm::dvec3 axis = std::abs(v.x) < 0.8 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  return glm::normalize(glm::cross(v, axis));
}

Basis basis_of(const Camera& camera) {
  Basis b{};
  const glm::dvec3 sight = camera.target - camera.eye;
  b.distance = glm::length(sight);
  b.forward = b.distance > 0 ? sight / b.distance : glm::dvec3(0, 0, 1);
  const double up_length = glm::length(camera.up);
  b.turntable_up = up_length > 0 ? camera.up / up_length : glm::dvec3(0, 1, 0);
  const glm::dvec3 right = glm::cross(b.forward, b.turntable_up);
  const double sine = glm::length(right);
  b.right = sine > 1e-9 ? right / sine : any_perpendicular(b.forward);
  b.up = glm::cross(b.right, b.forward);
  return b;
}

}  // namespace

Camera orbit(const Camera& camera, double yaw, double pitch) {
  const Basis b = basis_of(camera);
  if (!(b.distance > 0)) return camera;
  const glm::dvec3 axis = b.turntable_up;
  const double elevation = std::asin(std::clamp(-glm::dot(b.forward, axis), -1.0, 1.0));
  const double limit = std::numbers::pi / 2 - pole_margin;
  const double new_elevation = std::clamp(elevation + pitch, -limit, limit);
  // The horizontal direction towards the eye; `right` is horizontal even at a pole.
  const glm::dvec3 outwards = glm::cross(b.right, axis);
  const glm::dvec3 turned = outwards * std::cos(yaw) + glm::cross(axis, outwards) * std::sin(yaw);
  const glm::dvec3 to_eye = turned * std::cos(new_elevation) + axis * std::sin(new_elevation);
  Camera result = camera;
  result.up = axis;
  result.eye = camera.target + to_eye * b.distance;
  return result;
}

Camera look_along(const Camera& camera, glm::dvec3 direction) {
  Camera result = camera;
  result.eye = camera.target - direction * basis_of(camera).distance;
  result.up = std::abs(direction.z) > 0.5 ? glm::dvec3(0, 1, 0) : glm::dvec3(0, 0, 1);
  return result;
}

Camera roll(const Camera& camera, double radians) {
  const Basis b = basis_of(camera);
  Camera result = camera;
  result.up = b.up * std::cos(radians) - b.right * std::sin(radians);
  return result;
}

Camera with_other_projection(Camera camera) {
  camera.projection =
      camera.projection == Projection::parallel ? Projection::perspective : Projection::parallel;
  return camera;
}

Camera pan(const Camera& camera, glm::dvec2 share_of_height) {
  const Basis b = basis_of(camera);
  const double height = 2 * half_height_at_target(camera);
  const glm::dvec3 shift = (b.right * share_of_height.x + b.up * share_of_height.y) * -height;
  Camera result = camera;
  result.eye += shift;
  result.target += shift;
  return result;
}

Camera dolly(const Camera& camera, double factor, double distance_min, double distance_max) {
  const Basis b = basis_of(camera);
  Camera result = camera;
  const double distance = std::clamp(b.distance * factor, distance_min, distance_max);
  result.eye = camera.target - b.forward * distance;
  return result;
}

std::optional<std::pair<glm::dvec2, glm::dvec2>> project_segment(const Camera& camera, double aspect,
                                                                 glm::dvec3 from, glm::dvec3 to) {
  const Basis b = basis_of(camera);
  const double near_plane = camera.projection == Projection::parallel
                                ? -std::numeric_limits<double>::infinity()
                                : 1e-3 * b.distance;
  glm::dvec3 ends[2] = {from - camera.eye, to - camera.eye};
  double depth[2] = {glm::dot(ends[0], b.forward), glm::dot(ends[1], b.forward)};
  if (!(std::max(depth[0], depth[1]) > near_plane)) return std::nullopt;
  for (int i = 0; i < 2; ++i)
    if (depth[i] < near_plane) {
      const double t = (near_plane - depth[i]) / (depth[1 - i] - depth[i]);
      ends[i] += (ends[1 - i] - ends[i]) * t;
      depth[i] = near_plane;
    }
  const HalfHeight half = half_height(camera);
  const auto onto_view = [&](int i) {
    const double size = half(depth[i]);
    return glm::dvec2(glm::dot(ends[i], b.right) / (size * aspect), glm::dot(ends[i], b.up) / size);
  };
  return std::pair{onto_view(0), onto_view(1)};
}

}  // namespace crest
