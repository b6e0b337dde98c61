#include "render/volume/orientation.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace crest {

std::string orientation_note(const glm::dmat3& direction) {
  constexpr double tolerance = 1e-3;
  bool turned = false, skewed = false;
  for (int column = 0; column < 3; ++column) {
    for (int row = 0; row < 3; ++row)
      turned = turned || std::abs(direction[column][row] - (row == column ? 1 : 0)) > tolerance;
    skewed = skewed || std::abs(glm::dot(direction[column], direction[(column + 1) % 3])) > tolerance;
  }
  if (!turned) return {};
  const std::string kept = "and shown as they are stored";
  if (glm::determinant(direction) < 0) return "its axes are mirrored (left-handed), " + kept;
  if (skewed) return "its axes are not at right angles, " + kept;
  return "its axes are turned, " + kept;
}

}  // namespace crest
