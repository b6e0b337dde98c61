#pragma once

#include <array>
#include <compare>

#include "presets/preset.h"

namespace crest {

/// A reconstruction filter, with all that the field depends on.
struct FieldFilter {
  Filter kind = Filter::linear;
  double b = 0, c = 0;  ///< of Filter::bc; else 0, so that equal filters compare equal
  auto operator<=>(const FieldFilter&) const = default;
};

/// That of DVR samples.
FieldFilter dvr_filter(const Rendering& rendering);
/// That of the field in which surfaces lie: the same where `root_filter` is not set.
FieldFilter root_filter(const Rendering& rendering);

/// How many points a filter reaches on either side of a place along an axis: a value in the cell between
/// points i and i+1 is made from points i+1-radius .. i+radius, those beyond the grid's ends being its end
/// points (as a texture is clamped to its edge). 1 or 2.
int radius_of(const FieldFilter& filter);
/// The greatest radius of the filters that the mode samples with: a cell is empty if one of the points that
/// it reaches has no value.
int support_radius(const Rendering& rendering);

/// A weight as a polynomial of the place u in [0, 1] between two points: w[0] + w[1] u + w[2] u^2 + w[3] u^3.
using CubicWeight = std::array<double, 4>;

/// The weights of points i-1, i, i+1, i+2 at a place in the cell between i and i+1, on one axis; in three
/// dimensions a point's weight is the product over the axes. They sum to 1. The trilinear filters' outer two
/// are 0; the others are k(1+u), k(u), k(1-u), k(2-u) with the kernel of Mitchell and Netravali (1988, eq. 8)
///
///   6 k(x) = (12 - 9B - 6C) x^3 + (-18 + 12B + 6C) x^2 + (6 - 2B)               for x < 1,
///            (-B - 6C) x^3 + (6B + 30C) x^2 + (-12B - 48C) x + (8B + 24C)       for 1 <= x < 2,
///
/// whose derivative is continuous for every B and C. The cubic B-spline is B = 1, C = 0.
std::array<CubicWeight, 4> filter_weights(const FieldFilter& filter);

}  // namespace crest
