#pragma once

#include <cstdint>
#include <glm/vec4.hpp>

namespace crest {

/// How far a renderer that takes steps has come along a ray.
struct TracedStep {
  /// Of the last sample that was taken, or of the segment's end, in world units.
  double depth = 0;
  glm::vec4 color{0};           ///< collected so far: premultiplied RGBA
  std::uint32_t crossings = 0;  ///< composited so far
};

}  // namespace crest
