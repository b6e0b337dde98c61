#include "render/measure/pareto.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace crest {
std::vector<std::size_t> pareto_front(std::span<const WorkPrecision> points) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (std::isfinite(points[i].ms) && std::isfinite(points[i].error)) order.push_back(i);
  std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) {
    return std::pair(points[a].ms, points[a].error) < std::pair(points[b].ms, points[b].error);
  });
  std::vector<std::size_t> front;
  double least = std::numeric_limits<double>::infinity();
  for (const std::size_t i : order)
    if (points[i].error < least) {
      least = points[i].error;
      front.push_back(i);
    }
  return front;
}

std::vector<AnswerPoint> points_against(std::span<const Measurement> measured, const ExactAnswer& answer,
                                        const ErrorMeasure& measure) {
  std::vector<AnswerPoint> points;
  for (std::size_t i = 0; i < measured.size(); ++i)
    if (const ImageError* error = measured[i].error_against(answer))
      points.push_back({i, {measured[i].frame_ms, measure.value(*error)}});
  return points;
}

std::vector<std::size_t> pareto_front(std::span<const Measurement> measured, const ExactAnswer& answer,
                                      const ErrorMeasure& measure) {
  const auto candidates = points_against(measured, answer, measure);
  std::vector<WorkPrecision> points;
  for (const AnswerPoint& candidate : candidates) points.push_back(candidate.point);
  auto front = pareto_front(points);
  for (std::size_t& i : front) i = candidates[i].index;
  return front;
}

std::optional<std::size_t> cheapest_under(std::span<const Measurement> measured, const ExactAnswer& answer,
                                          const TargetError& target, std::string_view method) {
  std::optional<std::size_t> best;
  for (const AnswerPoint& p : points_against(measured, answer, *target.measure)) {
    const bool counts = method.empty() || measured[p.index].method == method;
    if (counts && p.point.error <= target.most && (!best || p.point.ms < measured[*best].frame_ms))
      best = p.index;
  }
  return best;
}

}  // namespace crest
