#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <string>
#include <vector>

#include "render/raycaster/raycaster.h"

namespace crest {

/// How far the ray caster has come along a ray.
struct TracedStep {
  double depth =
      0;  ///< of the last sample that was taken, or of the segment's end; from the entry, in world units
  glm::vec4 color{0};           ///< collected so far: premultiplied RGBA
  std::uint32_t crossings = 0;  ///< composited so far
};

/// Longer rays are not traced.
inline constexpr int most_traced_steps = 8192;

/// What the ray caster draws of one pixel of a picture, interval by interval: from the entry (nothing yet) to
/// the exit. It is the shader's own march, drawn as often as there are intervals, each time a bit further.
/// Skipping is left out, since it changes no sample. Empty where the ray misses the box. Throws Error where
/// the ray is too long, as draw(), and for the exact march, which has no samples.
std::vector<TracedStep> trace_ray(Raycaster& raycaster, Scene scene, const Camera& camera, glm::ivec2 size,
                                  glm::ivec2 pixel);

}  // namespace crest
