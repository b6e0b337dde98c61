#include "render/scene/view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "render/scene/camera.h"

namespace crest {
namespace {

std::array<glm::dvec3, 8> corners_of(const Box& box) {
  std::array<glm::dvec3, 8> corners;
  for (int i = 0; i < 8; ++i)
    corners[std::size_t(i)] = {i & 1 ? box.max.x : box.min.x, i & 2 ? box.max.y : box.min.y,
                               i & 4 ? box.max.z : box.min.z};
  return corners;
}

}  // namespace

// A box that lies wholly on the outer side of one of the view's sides, or behind the eye, is not seen.
bool may_see(const Camera& camera, double aspect, const Box& box) {
  if (box.is_empty()) return false;
  const CameraFrame frame = camera_frame(camera);
  const HalfHeight half = half_height(camera);
  const bool has_eye = camera.projection == Projection::perspective;
  const double size = has_eye ? 0 : glm::length(box.max - box.min);
  bool behind = has_eye, left = true, right = true, below = true, above = true;
  for (const glm::dvec3& corner : corners_of(box)) {
    const glm::dvec3 p = corner - camera.eye;
    const double depth = glm::dot(p, frame.w), x = glm::dot(p, frame.u), y = glm::dot(p, frame.v);
    const double height = half(depth), width = aspect * height;
    const double slack = 1e-5 * (glm::length(p) + size);  // rays are cast in float32
    behind = behind && depth < -slack;
    left = left && x < -width - slack * (1 + aspect * half.slope);
    right = right && x > width + slack * (1 + aspect * half.slope);
    below = below && y < -height - slack * (1 + half.slope);
    above = above && y > height + slack * (1 + half.slope);
  }
  return !(behind || left || right || below || above);
}

double longest_ray(const Camera& camera, const Box& box) {
  if (box.is_empty()) return 0;
  const glm::dvec3 size = box.max - box.min;
  if (camera.projection == Projection::parallel) {
    // None gets further on any axis than from face to face
    const glm::dvec3 direction = camera_frame(camera).w;
    double longest = glm::length(size);
    for (int axis = 0; axis < 3; ++axis)
      if (direction[axis] != 0) longest = std::min(longest, size[axis] / std::abs(direction[axis]));
    return longest;
  }
  const double nearest = glm::length(camera.eye - glm::clamp(camera.eye, box.min, box.max));
  double farthest = 0;
  for (const glm::dvec3& corner : corners_of(box))
    farthest = std::max(farthest, glm::length(corner - camera.eye));
  const double rounding = 0x1p-50 * farthest;  // of the two: from far away nothing else would be left
  return std::min(farthest - nearest + rounding, glm::length(size));
}

}  // namespace crest
