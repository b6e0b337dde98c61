#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "render/measure/convergence.h"
#include "render/measure/measurement.h"

namespace crest {

/// What work a picture took, and how precise it is: less is better in both.
struct WorkPrecision {
  double ms = 0, error = 0;
};

/// The indices of the points that no other beats: none is as good in both and better in one. By ascending
/// time, hence by descending error. Points that are no numbers take no part; of equal ones the first is kept.
std::vector<std::size_t> pareto_front(std::span<const WorkPrecision> points);

/// The points measured against an answer, in a measure; `index` is theirs in `measured`.
struct AnswerPoint {
  std::size_t index = 0;
  WorkPrecision point;
};
std::vector<AnswerPoint> points_against(std::span<const Measurement> measured, Answer answer,
                                        const ErrorMeasure& measure);

/// The indices into `measured` of the front against one answer.
std::vector<std::size_t> pareto_front(std::span<const Measurement> measured, Answer answer,
                                      const ErrorMeasure& measure);

/// The index of the fastest setting that meets the target against an answer; nothing where none does.
std::optional<std::size_t> cheapest_under(std::span<const Measurement> measured, Answer answer,
                                          const TargetError& target);

/// How a method converges to one of its exact answers.
struct Convergence {
  std::string method;
  Answer answer;
  /// Of the RMSE, over the finest steps above the rounding of 32-bit float: there the error is the method's
  /// leading term, if anywhere. Nothing with fewer than three such steps.
  std::optional<OrderFit> fit;
  /// The index of the fastest of its points that meets the target.
  std::optional<std::size_t> cheapest;
};

/// Where the RMSE of pictures in 32-bit float ends.
inline constexpr double rounding_rmse = 1e-6;
/// An order is fitted on so many of the finest steps.
inline constexpr int fitted_points = 4;

/// One for each method and answer that were measured, in the order in which they appear.
std::vector<Convergence> convergence_of(std::span<const Measurement> measured, const TargetError& target);

}  // namespace crest
