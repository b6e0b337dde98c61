#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "render/reference/pixel_ray.h"

namespace crest::reference {

/// How exactly places along a ray are known, in cells, summed over the axes.
template <class Real>
struct PlaceRounding {
  Real real = 0;      ///< in Real
  Real in_float = 0;  ///< were they in 32-bit float
};

template <class Real>
PlaceRounding<Real> place_rounding(glm::ivec3 dims, const PixelRay<Real>& ray) {
  // Positions in cells are good to a few roundings of the largest.
  return {std::numeric_limits<Real>::epsilon() * Real(4 * std::max({dims.x, dims.y, dims.z}) + 16),
          Real(ray.float_rounding.x + ray.float_rounding.y + ray.float_rounding.z)};
}

/// Where the field lies in a cell.
template <class Real>
struct CellBounds {
  Real low = 0, high = 0;
  Real float_rounding =
      0;  ///< of its values, in 32-bit float: four roundings, and their change over the place's
};

template <class Real>
CellBounds<Real> make_bounds(Real low, Real high, const PlaceRounding<Real>& place) {
  return {low, high, Real(0x1p-22) * std::max(std::abs(low), std::abs(high)) + (high - low) * place.in_float};
}

}  // namespace crest::reference
