#pragma once

#include <glm/common.hpp>
#include <optional>

#include "presets/preset.h"
#include "render/volume/volume.h"

namespace crest {

/// A box in world units; empty where max < min on an axis.
struct Box {
  glm::dvec3 min{0}, max{0};
  bool is_empty() const { return max.x < min.x || max.y < min.y || max.z < min.z; }
  bool operator==(const Box&) const = default;
};

/// The part of the volume's box that is rendered.
inline Box rendered_box(const Grid& grid, const std::optional<ClipBox>& clip) {
  if (!clip) return {grid.box_min(), grid.box_max()};
  return {glm::max(grid.box_min(), clip->min), glm::min(grid.box_max(), clip->max)};
}

}  // namespace crest
