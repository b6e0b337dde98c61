#pragma once

#include <glm/vec2.hpp>

#include "presets/preset.h"
#include "render/volume/clip.h"
#include "render/volume/volume.h"

namespace crest {

/// Bounds of how the rays of a picture are divided, in smallest spacings; they hold for each of its rays.
struct StepLengths {
  double longest = 0;  ///< between two samples next to each other
  double most = 0;     ///< segments of one ray in the box
};

/// How steps grow with the distance from the eye. Where no pixel grows, in parallel projection, the steps of
/// both samplings that do are s_k pixels' diagonals each: `differential` with nothing to grow by.
inline Sampling sampling_in(const Camera& camera, Sampling sampling) {
  const bool grows = camera.projection == Projection::perspective;
  return sampling == Sampling::footprint && !grows ? Sampling::differential : sampling;
}

/// More segments than this a ray are refused: it is what the least step makes of the largest volume.
inline constexpr double most_segments = 4e6;

/// Of a picture of `size` that the camera sees of the box. A box that is empty has no segments. Throws Error
/// for more than most_segments: differential steps, which grow with the root of the distance alone, are the
/// shorter by a pixel's width the further away the eye is.
StepLengths step_lengths(const Rendering& rendering, const Camera& camera, glm::ivec2 size, const Box& box,
                         const Grid& grid);

}  // namespace crest
