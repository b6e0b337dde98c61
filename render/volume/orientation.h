#pragma once

#include <array>
#include <glm/mat3x3.hpp>
#include <optional>
#include <string>

#include "render/volume/volume.h"

namespace crest {

/// What a viewer who tells left from right must know of axes that are shown as they are stored: mirrored,
/// turned or not at right angles. Empty when they are those of the world. Columns have length 1.
std::string orientation_note(const glm::dmat3& direction);

/// Where an axis of the grid goes from and to in a patient: 'R' and 'L', 'A' and 'P', 'I' and 'S'.
struct AxisEnds {
  char from = 0, to = 0;
  bool operator==(const AxisEnds&) const = default;
};
/// Each axis by the patient's direction that it is nearest to. Nothing where the volume's direction is not in
/// a patient's coordinates, or two axes would be the same.
std::optional<std::array<AxisEnds, 3>> anatomical_axes(const Volume& volume);

}  // namespace crest
