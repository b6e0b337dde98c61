#pragma once

#include "presets/preset.h"
#include "render/volume/clip.h"

namespace crest {

/// Whether a ray of the camera's picture may meet the box: false only if none does. `aspect` is the
/// picture's width by its height. Throws Error for a camera that has no picture.
bool may_see(const Camera& camera, double aspect, const Box& box);

/// No ray from the camera is longer in the box, in world units.
double longest_ray(const Camera& camera, const Box& box);

}  // namespace crest
