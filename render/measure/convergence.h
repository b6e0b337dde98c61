#pragma once

#include <optional>
#include <span>

namespace crest {

/// An order of convergence: error ~ size^order, where a method was refined.
struct OrderFit {
  double order = 0;                 ///< slope of log(error) over log(size), by least squares
  double coarsest = 0, finest = 0;  ///< the sizes (steps, spacings, pixels) between which it was fitted
  int points = 0;
};

/// Fits the refinement `sizes` (descending) with their `errors`, of which only the first ones above `floor`
/// count: below it the error is of rounding, not of the method. Nothing where fewer than `least_points` are
/// left.
std::optional<OrderFit> fit_order(std::span<const double> sizes, std::span<const double> errors, double floor,
                                  int least_points = 3);

}  // namespace crest
