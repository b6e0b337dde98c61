#include "render/volume/largest_change.h"

#include <algorithm>
#include <cmath>

#include "render/volume/filter_bounds.h"

namespace crest {

// The B-spline's derivative along an axis is a mean of differences of neighbours along it: first those of its
// four points, by the weights of the quadratic B-spline, none of which is negative and whose sum is 1; then
// on the other axes by its own weights, of which the same is true. No mean exceeds the largest of them, and
// so the trilinear field's bound is the B-spline's. FilterBounds::steepness is how much more it can be with
// negative weights.
double largest_change(const Grid& grid, const VolumeStatistics& statistics, const FieldFilter& filter,
                      double length) {
  const FilterBounds bounds = filter_bounds(filter);
  // Weights of 8 bits move a sample by up to 1/512 of a cell on each axis (those of each of the B-spline's
  // fetches, of which it is a mean, likewise); float32 rounds
  const glm::dvec3 d = statistics.largest_difference;
  const double weights = 2 * (d.x + d.y + d.z) / 512;
  const double rounding = 0x1p-20 * (1 + 2 * bounds.overshoot) *
                          std::max(std::abs(statistics.range.min), std::abs(statistics.range.max));
  return bounds.steepness * (largest_gradient(grid, statistics) * length + weights) + rounding;
}

}  // namespace crest
