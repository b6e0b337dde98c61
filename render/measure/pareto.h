#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

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
std::vector<AnswerPoint> points_against(std::span<const Measurement> measured, const ExactAnswer& answer,
                                        const ErrorMeasure& measure);

/// The indices into `measured` of the front against one answer.
std::vector<std::size_t> pareto_front(std::span<const Measurement> measured, const ExactAnswer& answer,
                                      const ErrorMeasure& measure);

/// The index of the fastest setting that meets the target against an answer, of one method or of any; nothing
/// where none does.
std::optional<std::size_t> cheapest_under(std::span<const Measurement> measured, const ExactAnswer& answer,
                                          const TargetError& target, std::string_view method = {});

}  // namespace crest
