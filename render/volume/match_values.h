#pragma once

#include <functional>
#include <vector>

#include "render/volume/volume.h"

namespace crest {

/// How a volume's voxels spread over its values: for each value that there is, the share of the voxels below
/// it and half of those that have it. Values within one of 65536 equal bins over the range count as its
/// middle.
struct ValueDistribution {
  ValueRange range;
  std::vector<double> value, share;  ///< both ascending; empty where no voxel has a value
};
ValueDistribution distribution_of(const Volume& volume);

/// How a TF is carried from one volume to another.
enum class CarryBy {
  histogram,  ///< a value goes to that with as many voxels below it: a monotone map (matched_value)
  range,      ///< the one's range is laid over the other's
  value,      ///< a value stays what it is
  places      ///< by what the two have at the same places (fit_values.h): asks for both volumes
};

/// The value of `to` with the same share of the voxels below it as `value` has in `from`; linear between the
/// values that there are, and beyond the ends as far off as the two ranges' widths say.
///
/// Where `to` is the same volume with a monotone map g of its values, g(value) is found but for 1/65536 of
/// both ranges (of the one by the slope of g), and but for how far g is from a line between two neighbouring
/// values. Where the shares of the materials differ, air around a scan above all, so do the results.
double matched_value(const ValueDistribution& from, const ValueDistribution& to, double value);

/// The points go where an ascending map sends their values. A spike that is shown as a surface goes as a
/// whole, by its peak, and its width by `width_ratio`, of the values' widths.
TransferFunction carried_by(const TransferFunction& tf, const std::function<double(double)>& map,
                            double width_ratio);

/// `tf` has data values of `from`; `by` is none that asks for the volumes. A spike that is shown as a surface
/// goes as a whole, by its peak, and its width by the ranges: else it would no longer be one. Unit distance
/// and the rest stay.
TransferFunction carried(const TransferFunction& tf, const ValueDistribution& from,
                         const ValueDistribution& to, CarryBy by);

}  // namespace crest
