#pragma once

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <vector>

#include "presets/peaks.h"
#include "render/scene/camera.h"
#include "render/volume/volume.h"

namespace crest::testing {

/// The trilinear field in double, at a position in units of the smallest spacing from the box's first point.
inline double trilinear(const Volume& volume, glm::dvec3 position) {
  const glm::dvec3 p = position * volume.grid.smallest_spacing() / volume.grid.spacing;
  const glm::ivec3 cell = glm::clamp(glm::ivec3(glm::floor(p)), glm::ivec3(0), volume.grid.dims - 2);
  const glm::dvec3 w = p - glm::dvec3(cell);
  double sum = 0;
  for (int corner = 0; corner < 8; ++corner) {
    const glm::ivec3 o(corner & 1, corner >> 1 & 1, corner >> 2);
    const double weight = (o.x ? w.x : 1 - w.x) * (o.y ? w.y : 1 - w.y) * (o.z ? w.z : 1 - w.z);
    sum += weight * double(volume.at(cell.x + o.x, cell.y + o.y, cell.z + o.z));
  }
  return sum;
}

/// A pixel's ray, and where it is in the box.
struct BruteRay {
  glm::dvec3 origin, direction;
  double enter = 0, exit = -1;
  bool hits() const { return exit >= enter; }
};

inline BruteRay brute_ray(const Camera& camera, const Grid& grid, glm::ivec2 size, int x, int y) {
  const CameraFrame frame = camera_frame(camera);
  const double half = std::tan(glm::radians(0.5 * camera.fov_y_degrees));
  const double px = (2 * (x + 0.5) / size.x - 1) * half * size.x / size.y,
               py = (1 - 2 * (y + 0.5) / size.y) * half;
  BruteRay ray;
  ray.origin = (camera.eye - grid.origin) / grid.smallest_spacing();
  ray.direction = glm::normalize(frame.w + px * frame.u + py * frame.v);
  const glm::dvec3 box = grid.box_size() / grid.smallest_spacing();
  ray.enter = 0;
  ray.exit = 1e300;
  for (int axis = 0; axis < 3; ++axis) {
    if (ray.direction[axis] == 0) {
      if (ray.origin[axis] < 0 || ray.origin[axis] > box[axis]) ray.exit = -1;
      continue;
    }
    const double a = -ray.origin[axis] / ray.direction[axis];
    const double b = (box[axis] - ray.origin[axis]) / ray.direction[axis];
    ray.enter = std::max(ray.enter, std::min(a, b));
    ray.exit = std::min(ray.exit, std::max(a, b));
  }
  return ray;
}

/// Changes of side of the isovalue along a ray, at `per_unit` samples for each smallest spacing.
inline int brute_crossings(const Volume& volume, const BruteRay& ray, double isovalue, int per_unit) {
  if (!ray.hits()) return 0;
  const int n = std::max(2, int((ray.exit - ray.enter) * per_unit));
  int crossings = 0;
  bool inside = false;
  for (int i = 0; i <= n; ++i) {
    const double t = ray.enter + (ray.exit - ray.enter) * i / n;
    const bool now = trilinear(volume, ray.origin + t * ray.direction) >= isovalue;
    if (i > 0 && now != inside) ++crossings;
    inside = now;
  }
  return crossings;
}

}  // namespace crest::testing
