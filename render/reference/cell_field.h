#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "render/reference/pixel_ray.h"
#include "render/volume/volume.h"

namespace crest::reference {

/// How exactly places along a ray are known, in cells, summed over the axes; and values.
template <class Real>
struct Roundings {
  Real place = 0;           ///< in Real
  Real place_in_float = 0;  ///< were they in 32-bit float
  /// No value is larger where a device holds the field: one far from zero is held less a base
  /// (classify/stored_units.h).
  Real largest_held = 0;
};

template <class Real>
Roundings<Real> roundings_of(const Volume& volume, const PixelRay<Real>& ray) {
  // Positions in cells are good to a few roundings of the largest.
  const glm::ivec3 dims = volume.grid.dims;
  return {std::numeric_limits<Real>::epsilon() * Real(4 * std::max({dims.x, dims.y, dims.z}) + 16),
          Real(ray.float_rounding.x + ray.float_rounding.y + ray.float_rounding.z),
          Real(2 * volume.statistics.range.width())};
}

/// Where the field lies in a cell.
template <class Real>
struct CellBounds {
  Real low = 0, high = 0;
  Real float_rounding =
      0;  ///< of its values, in 32-bit float: four roundings, and their change over the place's
};

template <class Real>
CellBounds<Real> make_bounds(Real low, Real high, const Roundings<Real>& roundings) {
  const Real held = std::min(std::max(std::abs(low), std::abs(high)), roundings.largest_held);
  return {low, high, Real(0x1p-22) * held + (high - low) * roundings.place_in_float};
}

}  // namespace crest::reference
