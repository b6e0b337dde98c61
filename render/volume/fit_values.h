#pragma once

#include <vector>

#include "render/volume/volume.h"

namespace crest {

/// The monotone map g of one volume's values to another's that leaves the least sum of (to - g(from))^2 over
/// the voxels of a grid that both share: of each value the mean of the other volume at the same places, as
/// far as that is monotone, and pooled where it is not (isotonic regression by pool-adjacent-violators: Ayer
/// et al., 1955).
///
/// Neuhauser and Westermann (Transfer Function Optimization for Comparative Volume Rendering, 2023) fit the
/// other volume's table of colours by least squares over the voxels. Here the map of values is fitted, so
/// that points stay points, and a spike is not blurred over the table's entries.
struct ValueFit {
  std::vector<double> from, to;     ///< g is linear between these; `from` ascends
  bool is_decreasing = false;       ///< what is bright in the one is dark in the other
  double explained = 0;             ///< share of the variance of `to` that g explains, in [0, 1]
  ValueRange from_range, to_range;  ///< of the volumes
};

/// Throws Error unless the volumes have as many points on each axis, and a voxel where both have a value.
///
/// Where `to` is a monotone map of `from`, it is found but for 1/65536 of the range of `from` (times its
/// slope). Noise in `from` flattens g, as in every regression.
ValueFit fit_values(const Volume& from, const Volume& to);

/// g(value); beyond the ends as far off as the two ranges' widths say.
double fitted_value(const ValueFit& fit, double value);

/// `tf` has data values of the first volume. As carried() by histogram does: spikes stay spikes. A decreasing
/// map turns the order of the points.
TransferFunction carried(const TransferFunction& tf, const ValueFit& fit);

}  // namespace crest
