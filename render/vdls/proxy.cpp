#include "render/vdls/proxy.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

#include "render/scene/camera.h"

namespace crest {
namespace {

double cross(glm::dvec2 a, glm::dvec2 b) { return a.x * b.y - a.y * b.x; }

/// The convex hull, by Andrew's monotone chain.
std::vector<glm::dvec2> hull_of(std::vector<glm::dvec2> points) {
  std::ranges::sort(points,
                    [](glm::dvec2 a, glm::dvec2 b) { return a.x < b.x || (a.x == b.x && a.y < b.y); });
  std::vector<glm::dvec2> hull;
  for (int chain = 0; chain < 2; ++chain) {
    const std::size_t first = hull.size();
    for (const glm::dvec2 p : points) {
      while (hull.size() >= first + 2 &&
             cross(hull.back() - hull[hull.size() - 2], p - hull[hull.size() - 2]) <= 0)
        hull.pop_back();
      hull.push_back(p);
    }
    hull.pop_back();  // the other chain begins with it
    std::ranges::reverse(points);
  }
  return hull;
}

/// The box's corners in the camera's axes (right, up, forward), and where its edges pass `nearest` forward:
/// only what lies beyond, where the camera has an eye that nothing is seen behind.
std::vector<glm::dvec3> corners_before_eye(const Box& box, const Camera& camera) {
  const double nearest =
      camera.projection == Projection::perspective
          ? 1e-4 * glm::length(box.max - box.min) + 1e-9 * glm::length(camera.eye - box.min)
          : -std::numeric_limits<double>::infinity();
  const CameraFrame frame = camera_frame(camera);
  const auto seen = [&](int corner) {
    const glm::dvec3 p =
        glm::mix(box.min, box.max, glm::dvec3(corner & 1, corner >> 1 & 1, corner >> 2)) - camera.eye;
    return glm::dvec3(glm::dot(p, frame.u), glm::dot(p, frame.v), glm::dot(p, frame.w));
  };
  std::vector<glm::dvec3> corners;
  for (int i = 0; i < 8; ++i) {
    const glm::dvec3 a = seen(i);
    if (a.z >= nearest) corners.push_back(a);
    for (int axis = 1; axis < 8; axis *= 2) {
      const glm::dvec3 b = seen(i ^ axis);
      if (a.z >= nearest && b.z < nearest) corners.push_back(glm::mix(a, b, (nearest - a.z) / (b.z - a.z)));
    }
  }
  return corners;
}

}  // namespace

int Proxy::corners_beyond(int layer) const {
  const auto done =
      std::ranges::partition_point(parts, [&](const Part& part) { return part.layers > layer; });
  return done == parts.begin() ? 0 : std::prev(done)->end;
}

Proxy proxy_of(std::vector<ScreenNode> nodes) {
  std::ranges::sort(nodes, std::ranges::greater(), &ScreenNode::layers);
  Proxy proxy;
  for (const ScreenNode& node : nodes) {
    const glm::vec2 a(node.begin), b(node.begin + node.side);
    proxy.corners.insert(proxy.corners.end(), {a, {b.x, a.y}, b, a, b, {a.x, b.y}});
    proxy.parts.push_back({node.layers, int(proxy.corners.size())});
  }
  return proxy;
}

Proxy proxy_of(const Box& box, const Camera& camera, glm::ivec2 size, int layers) {
  Proxy proxy;
  if (box.is_empty() || layers == 0) return proxy;
  const HalfHeight half = half_height(camera);
  std::vector<glm::dvec2> points;
  for (const glm::dvec3& p : corners_before_eye(box, camera)) {
    const double height = half(p.z), width = height * aspect_of(size);
    const glm::dvec2 pixel = 0.5 * (glm::dvec2(p.x / width, -p.y / height) + 1.0) * glm::dvec2(size);
    for (int corner = 0; corner < 4; ++corner)
      points.push_back(pixel + glm::dvec2(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1));
  }
  if (points.empty()) return proxy;
  const auto hull = hull_of(std::move(points));
  for (std::size_t i = 2; i < hull.size(); ++i)
    proxy.corners.insert(proxy.corners.end(),
                         {glm::vec2(hull[0]), glm::vec2(hull[i - 1]), glm::vec2(hull[i])});
  proxy.parts = {{layers, int(proxy.corners.size())}};
  return proxy;
}

}  // namespace crest
