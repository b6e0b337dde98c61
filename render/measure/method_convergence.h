#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "render/measure/convergence.h"
#include "render/measure/measurement.h"

namespace crest {

/// How a method converges to one of its exact answers.
struct MethodConvergence {
  std::string method;
  ExactAnswer answer;
  /// Of the RMSE: see fit_finest_order().
  std::optional<OrderFit> fit;
  /// The index of the fastest of its points that meets the target.
  std::optional<std::size_t> cheapest;
  /// All its finer steps meet it, too; else the cheapest one may owe it to chance.
  bool steady = true;
};

/// One for each method and answer that were measured, in the order in which they appear.
std::vector<MethodConvergence> convergence_of(std::span<const Measurement> measured,
                                              const TargetError& target);

/// Fits an order where there is one: on the finest run of steps, as long as can be and of three at least,
/// over which the error is a power of the step to within `order_residual`. Below `rounding_rmse`, steps at
/// which it no longer falls belong to the rounding of 32-bit float, and are left out. `steps` descend.
std::optional<OrderFit> fit_finest_order(std::span<const double> steps, std::span<const double> rmse);

inline constexpr double rounding_rmse = 1e-5;
inline constexpr double order_residual = 0.1;  ///< in powers of two: 7 %

}  // namespace crest
