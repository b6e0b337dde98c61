#include "render/volume/orientation.h"

#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <utility>

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

std::optional<std::array<AxisEnds, 3>> anatomical_axes(const Volume& volume) {
  constexpr AxisEnds patient[3] = {{'R', 'L'}, {'A', 'P'}, {'I', 'S'}};
  if (!volume.is_in_patient) return std::nullopt;
  std::array<AxisEnds, 3> axes;
  bool taken[3] = {};
  for (int axis = 0; axis < 3; ++axis) {
    const glm::dvec3 along = volume.direction[axis], size = glm::abs(along);
    const int nearest = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    if (std::exchange(taken[nearest], true)) return std::nullopt;
    const AxisEnds ends = patient[nearest];
    axes[std::size_t(axis)] = along[nearest] < 0 ? AxisEnds{ends.to, ends.from} : ends;
  }
  return axes;
}

}  // namespace crest
