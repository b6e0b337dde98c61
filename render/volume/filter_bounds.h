#pragma once

#include "render/volume/filter.h"

namespace crest {

/// How a filter's field is bounded by the grid's points that it is made from.
struct FilterBounds {
  /// Points that it reaches on either side (radius_of): those that bound a box of cells are the box's own
  /// corners and `radius - 1` more around them.
  int radius = 1;
  /// Where these points' values lie in [low, high], the field lies in
  /// [low - overshoot (high - low), high + overshoot (high - low)]. 0 where no weight is negative: linear,
  /// linear_exact, bspline.
  double overshoot = 0;
  /// The field's derivative along an axis is at most this many times the largest difference of two
  /// neighbours on that axis, by their distance. 1 for linear, linear_exact and bspline.
  double steepness = 1;
};

/// With weights w that sum to 1 and S = max over u of sum |w_i(u)|, S^3 bounds the sum of the three axes'
/// products, whose negative part is therefore at most (S^3 - 1) / 2: overshoot. Along an axis the derivative
/// is, summed by parts, sum_j D_j(u) (v_{j+1} - v_j), D_j = sum over i > j of w_i'(u): steepness is
/// max over u of sum |D_j(u)|, times S^2 for the other two axes. (The B-spline's D_j are the quadratic
/// B-spline's weights: none is negative and they sum to 1.) The maxima are exact, rounding apart.
FilterBounds filter_bounds(const FieldFilter& filter);

/// `points` widened to what the field between them can have.
ValueRange field_range(const FieldFilter& filter, ValueRange points);

}  // namespace crest
