#pragma once

#include <glm/vec2.hpp>

#include "presets/preset.h"
#include "render/volume/clip.h"

namespace crest {

/// Bounds of how the rays of a picture are divided, in smallest spacings; they hold for each of its rays.
struct StepLengths {
  double longest = 0;  ///< between two samples next to each other
  double most = 0;     ///< segments of one ray in the box
};

/// s_k times a pixel's diagonal on the image plane at distance 1 (Knoll et al. 2009, section 5.3).
double differential_k(const Camera& camera, glm::ivec2 size, double s_k);

/// More segments than this a ray are refused: it is what the least step makes of the largest volume.
inline constexpr double most_segments = 4e6;

/// Of a picture of `size` that the camera sees of the box. A box that is empty has no segments. Throws Error
/// for more than most_segments: differential steps, which grow with the root of the distance alone, are the
/// shorter by a pixel's width the further away the eye is.
StepLengths step_lengths(const Rendering& rendering, const Camera& camera, glm::ivec2 size, const Box& box,
                         double smallest_spacing);

}  // namespace crest
