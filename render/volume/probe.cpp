#include "render/volume/probe.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

namespace crest {

std::optional<double> value_at(const Volume& volume, const FieldFilter& filter, glm::dvec3 place) {
  const glm::ivec3 last = volume.grid.dims - 1;
  const auto weights = filter_weights(filter);
  glm::ivec3 cell(0);
  double weight[3][4];
  for (int axis = 0; axis < 3; ++axis) {
    const double at = std::clamp(place[axis], 0.0, 1.0) * last[axis];
    cell[axis] = std::min(int(at), last[axis] - 1);
    const double u = at - cell[axis];
    for (std::size_t i = 0; i < 4; ++i) {
      const CubicWeight& w = weights[i];
      weight[axis][i] = w[0] + u * (w[1] + u * (w[2] + u * w[3]));
    }
  }
  // Points i - 1 .. i + 2; of the trilinear filters' the outer two count for nothing, NaN or not
  const int first = radius_of(filter) == 1 ? 1 : 0, past = radius_of(filter) == 1 ? 3 : 4;
  double sum = 0;
  for (int k = first; k < past; ++k)
    for (int j = first; j < past; ++j)
      for (int i = first; i < past; ++i) {
        const glm::ivec3 point = glm::clamp(cell + glm::ivec3(i, j, k) - 1, glm::ivec3(0), last);
        sum += weight[0][i] * weight[1][j] * weight[2][k] * double(volume.at(point.x, point.y, point.z));
      }
  return std::isfinite(sum) ? std::optional(sum) : std::nullopt;
}

}  // namespace crest
