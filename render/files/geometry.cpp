#include "render/files/geometry.h"

#include <fmt/core.h>

#include <cmath>

#include "render/volume/take_part.h"

namespace crest {

void repair_geometry(Volume& volume) {
  const auto add_note = [&](const std::string& text) {
    volume.note += (volume.note.empty() ? "" : "; ") + text;
  };
  for (int axis = 0; axis < 3; ++axis) {
    double& spacing = volume.grid.spacing[axis];
    const double given = spacing;
    spacing = std::abs(spacing);
    if (spacing > 0 && std::isfinite(spacing)) continue;
    spacing = 1;
    add_note(fmt::format("the file's spacing {} on axis {} is taken as 1", given, axis + 1));
  }
  for (int axis = 0; axis < 3; ++axis) {
    double& origin = volume.grid.origin[axis];
    origin += 0.0;  // no -0
    if (std::isfinite(origin)) continue;
    add_note(fmt::format("the file's origin {} on axis {} is taken as 0", origin, axis + 1));
    origin = 0;
  }
  for (int column = 0; column < 3; ++column) {
    for (int row = 0; row < 3; ++row) {
      if (!std::isfinite(volume.direction[column][row])) volume.direction = glm::dmat3(1);
    }
  }
}

void place_part(Volume& volume, const GridPart& part) {
  repair_geometry(volume);
  take_part(volume, part);
}

}  // namespace crest
