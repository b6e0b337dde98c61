#pragma once

#include <glm/mat3x3.hpp>
#include <string>

namespace crest {

/// What a viewer who tells left from right must know of axes that are shown as they are stored: mirrored,
/// turned or not at right angles. Empty when they are those of the world. Columns have length 1.
std::string orientation_note(const glm::dmat3& direction);

}  // namespace crest
