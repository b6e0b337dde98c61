#pragma once

#include <vector>

#include "presets/preset.h"
#include "render/scene/picture_cost.h"
#include "render/volume/clip.h"

namespace crest {

/// Rectangles of a picture, none over another, that hold every pixel whose ray meets one of the boxes (in world
/// units): what else they hold is within some pixels of one. Where the eye is in a box, that is the whole picture.
std::vector<Tile> parts_that_meet(const std::vector<Box>& boxes, const Camera& camera, glm::ivec2 size);

/// The box in so many equal ones that their rectangles follow its outline.
std::vector<Box> divided(const Box& box);

}  // namespace crest
