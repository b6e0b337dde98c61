#pragma once

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

#include "render/volume/filter.h"
#include "render/volume/volume.h"

namespace crest::testing {

/// Mitchell and Netravali's kernel as they print it (1988, eq. 8).
inline double cubic_kernel(double b, double c, double x) {
  x = std::abs(x);
  if (x < 1) return ((12 - 9 * b - 6 * c) * x * x * x + (-18 + 12 * b + 6 * c) * x * x + (6 - 2 * b)) / 6;
  if (x < 2)
    return ((-b - 6 * c) * x * x * x + (6 * b + 30 * c) * x * x + (-12 * b - 48 * c) * x + (8 * b + 24 * c)) /
           6;
  return 0;
}

inline double kernel_of(const FieldFilter& filter, double x) {
  if (radius_of(filter) == 1) return std::max(0.0, 1 - std::abs(x));
  return filter.kind == Filter::bspline ? cubic_kernel(1, 0, x) : cubic_kernel(filter.b, filter.c, x);
}

/// A filter's field in double, as a plain sum over all points within its reach, at a position in units of the
/// smallest spacing from the box's first point.
inline double reconstruct(const Volume& volume, const FieldFilter& filter, glm::dvec3 position) {
  const glm::dvec3 p = position * volume.grid.smallest_spacing() / volume.grid.spacing;
  const glm::ivec3 base = glm::floor(p), last = volume.grid.dims - 1;
  const int radius = radius_of(filter);
  double sum = 0;
  for (int k = base.z + 1 - radius; k <= base.z + radius; ++k)
    for (int j = base.y + 1 - radius; j <= base.y + radius; ++j)
      for (int i = base.x + 1 - radius; i <= base.x + radius; ++i)
        sum +=
            kernel_of(filter, p.x - i) * kernel_of(filter, p.y - j) * kernel_of(filter, p.z - k) *
            double(volume.at(std::clamp(i, 0, last.x), std::clamp(j, 0, last.y), std::clamp(k, 0, last.z)));
  return sum;
}

}  // namespace crest::testing
