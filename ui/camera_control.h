#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <utility>

#include "presets/preset.h"

namespace crest {

/// Turns the camera about its target like a turntable: by `yaw` about its up axis, then by `pitch` towards
/// (or away from) it, in radians. It stops just short of the poles, so that up never flips.
Camera orbit(const Camera& camera, double yaw, double pitch);

/// Looks at the same target from as far away, along a direction of length 1; z is up, or y where it looks
/// along z.
Camera look_along(const Camera& camera, glm::dvec3 direction);

/// Turned about the line of sight, clockwise as the person sees the picture turn for a positive angle.
Camera roll(const Camera& camera, double radians);

/// Perspective for parallel, or the other way; what lies in the target's plane stays where it is.
Camera with_other_projection(Camera camera);

/// Moves eye and target across the view, by a share of the view's height at the target's distance:
/// (0, 1) moves the picture up by the whole height.
Camera pan(const Camera& camera, glm::dvec2 share_of_height);

/// Multiplies the distance between eye and target by `factor`, kept within `distance_min` and `distance_max`:
/// a smaller one magnifies, in parallel projection too.
Camera dolly(const Camera& camera, double factor, double distance_min, double distance_max);

/// Where a segment appears in a view of `aspect` (width / height): its ends in [-1, 1]^2 for what is inside
/// the view, x to the right and y up. In perspective the part behind the eye is cut off; nothing when all
/// of it is.
std::optional<std::pair<glm::dvec2, glm::dvec2>> project_segment(const Camera& camera, double aspect,
                                                                 glm::dvec3 from, glm::dvec3 to);

}  // namespace crest
