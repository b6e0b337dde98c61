#include "render/raycaster/drawn_parts.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <optional>

#include "render/scene/camera.h"

namespace crest {
namespace {

/// Pixels along the side of a square that is drawn or left out: smaller ones take more draws than they save.
constexpr int side = 16;

/// Where places are seen.
struct PlaceOnPicture {
  CameraFrame frame;
  glm::dvec3 eye;
  bool has_eye;  ///< behind which nothing is seen
  HalfHeight half_height;
  glm::dvec2 size;  ///< in pixels

  PlaceOnPicture(const Camera& camera, glm::ivec2 pixels)
      : frame(camera_frame(camera)),
        eye(camera.eye),
        has_eye(camera.projection == Projection::perspective),
        half_height(crest::half_height(camera)),
        size(pixels) {}
  /// Pixel x and y, and how far before the eye.
  glm::dvec3 operator()(glm::dvec3 place) const {
    const glm::dvec3 p = place - eye;
    const double depth = glm::dot(p, frame.w), height = half_height(depth);
    const glm::dvec2 across =
        glm::dvec2(glm::dot(p, frame.u) * size.y / size.x, -glm::dot(p, frame.v)) / height;
    return {0.5 * (across + 1.0) * size, depth};
  }
};

/// The box on the picture, a pixel wider all around than it is, for what is rounded; nothing behind the eye,
/// and the whole picture about it.
std::optional<Tile> seen(const PlaceOnPicture& place, const Box& box) {
  const double nearest = 1e-4 * glm::length(box.max - box.min) + 1e-9 * glm::length(place.eye - box.min);
  glm::dvec2 low(std::numeric_limits<double>::infinity()), high(-low);
  int before = 0, behind = 0;
  for (int corner = 0; corner < 8; ++corner) {
    const glm::dvec3 p =
        place(glm::mix(box.min, box.max, glm::dvec3(corner & 1, corner >> 1 & 1, corner >> 2)));
    before += !place.has_eye || p.z >= nearest;
    behind += place.has_eye && p.z < -nearest;
    low = glm::min(low, glm::dvec2(p));
    high = glm::max(high, glm::dvec2(p));
  }
  if (behind == 8) return {};
  if (before < 8) return Tile{{0, 0}, glm::ivec2(place.size)};
  const Tile tile{glm::ivec2(glm::clamp(low - 1.0, glm::dvec2(0), place.size)),
                  glm::ivec2(glm::clamp(high + 2.0, glm::dvec2(0), place.size))};
  if (tile.begin.x >= tile.end.x || tile.begin.y >= tile.end.y) return {};
  return tile;
}

}  // namespace

std::vector<Tile> parts_that_meet(const std::vector<Box>& boxes, const Box& rendered, const Camera& camera,
                                  glm::ivec2 size, Tile tile) {
  const PlaceOnPicture place(camera, size);
  const glm::ivec2 squares = (size + side - 1) / side;
  std::vector<std::vector<bool>> drawn(std::size_t(squares.y), std::vector<bool>(std::size_t(squares.x)));
  for (const Box& whole : boxes) {
    const Box box{glm::max(whole.min, rendered.min), glm::min(whole.max, rendered.max)};
    const auto on_picture = box.is_empty() ? std::nullopt : seen(place, box);
    if (!on_picture) continue;
    const glm::ivec2 first = on_picture->begin / side, last = (on_picture->end - 1) / side;
    for (int row = first.y; row <= last.y; ++row)
      std::fill_n(drawn[std::size_t(row)].begin() + first.x, last.x - first.x + 1, true);
  }
  std::vector<Tile> parts;
  for (int row = 0; row < squares.y; ++row) {
    const auto& here = drawn[std::size_t(row)];
    for (auto begin = std::find(here.begin(), here.end(), true); begin != here.end();) {
      const auto end = std::find(begin, here.end(), false);
      const glm::ivec2 first(int(begin - here.begin()), row), past(int(end - here.begin()), row + 1);
      const Tile part{glm::max(first * side, tile.begin), glm::min(past * side, tile.end)};
      if (part.begin.x < part.end.x && part.begin.y < part.end.y) parts.push_back(part);
      begin = std::find(end, here.end(), true);
    }
  }
  return parts;
}

std::vector<Tile> PictureParts::that_meet(const std::vector<Box>& boxes, const Box& rendered,
                                          const Camera& camera, glm::ivec2 size, Tile tile) {
  constexpr std::size_t most_known = 8;  // four views, coarse and in full
  const auto is_same = [&](const Known& one) {
    return one.size == size && one.camera == camera && one.rendered == rendered && one.boxes == boxes;
  };
  auto found = std::ranges::find_if(known_, is_same);
  if (found == known_.end()) {
    if (known_.size() == most_known) known_.pop_back();
    known_.push_front(
        {boxes, rendered, camera, size, parts_that_meet(boxes, rendered, camera, size, Tile{{0, 0}, size})});
    found = known_.begin();
  }
  std::vector<Tile> parts;
  for (const Tile& whole : found->parts) {
    const Tile part{glm::max(whole.begin, tile.begin), glm::min(whole.end, tile.end)};
    if (part.begin.x < part.end.x && part.begin.y < part.end.y) parts.push_back(part);
  }
  return parts;
}

std::vector<Box> divided(const Box& box) {
  constexpr int n = 8;
  std::vector<Box> boxes;
  for (int i = 0; i < n * n * n; ++i) {
    const glm::dvec3 at(i % n, i / n % n, i / n / n);
    boxes.push_back(
        {glm::mix(box.min, box.max, at / double(n)), glm::mix(box.min, box.max, (at + 1.0) / double(n))});
  }
  return boxes;
}

}  // namespace crest
