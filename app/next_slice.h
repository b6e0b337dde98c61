#pragma once

#include "render/scene/picture_cost.h"

namespace crest {

/// The part of a picture that is drawn next, of about `pixels`, where all before `begin` is drawn: some whole
/// rows, or where four rows are already too many pixels, a part of four rows, at least 16 pixels wide.
Tile next_slice(glm::ivec2 size, glm::ivec2 begin, double pixels);

/// Where the slice after this one begins: (0, size.y) behind the last one.
glm::ivec2 after(const Tile& slice, glm::ivec2 size);

}  // namespace crest
