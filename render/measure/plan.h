#pragma once

#include <optional>
#include <span>
#include <vector>

#include "render/measure/measurement.h"
#include "render/measure/methods.h"

namespace crest {

/// The steps that a sweep may measure: 4, 2, 1, ... 1/64 of the smallest spacing.
std::span<const double> sweep_steps();

/// A point that a sweep could measure next.
struct PlannedPoint {
  const Method* method = nullptr;
  double step = 0;
  Why why = Why::rest;
  /// Its frame's time as the points so far foretell it; nothing while there are none.
  std::optional<double> expected_ms;
};

/// All points that are not measured yet, the most informative first: every method at 4, then at 1, then at
/// 1/4; then those that bring a method's cheapest setting under the target to light, by bisection; then the
/// neighbours of the Pareto fronts; then the rest, and last what another method surely beats in both time
/// and error. Within one kind the cheaper comes first.
std::vector<PlannedPoint> plan_points(std::span<const Method* const> methods,
                                      std::span<const Measurement> measured, const TargetError& target);

/// A method's frame time at a step: taken from the nearest step that was measured, and in proportion to the
/// samples where that is coarser; before its first, that of the slowest other method.
std::optional<double> expected_frame_ms(std::string_view method, double step,
                                        std::span<const Measurement> measured);

/// A method's error at a step, from the power law through its two nearest steps; nothing with fewer.
std::optional<double> expected_error(std::string_view method, double step, const ExactAnswer& answer,
                                     const ErrorMeasure& measure, std::span<const Measurement> measured);

}  // namespace crest
