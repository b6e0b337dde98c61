#include "render/measure/pareto.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace crest {
namespace {

std::optional<OrderFit> fit_finest(std::span<const Measurement> measured, const std::string& method,
                                   Answer answer) {
  std::vector<std::pair<double, double>> points;  // step, error
  for (const Measurement& m : measured) {
    const ImageError* error = m.error_against(answer);
    if (m.method == method && m.step > 0 && error) points.emplace_back(m.step, error->compared.rmse);
  }
  std::ranges::sort(points, std::greater{});
  while (!points.empty() && !(points.back().second > rounding_rmse)) points.pop_back();
  const std::size_t first = points.size() - std::min(points.size(), std::size_t(fitted_points));
  std::vector<double> steps, errors;
  for (std::size_t i = first; i < points.size(); ++i) {
    steps.push_back(points[i].first);
    errors.push_back(points[i].second);
  }
  return fit_order(steps, errors, rounding_rmse);
}

}  // namespace

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

std::vector<AnswerPoint> points_against(std::span<const Measurement> measured, Answer answer,
                                        const ErrorMeasure& measure) {
  std::vector<AnswerPoint> points;
  for (std::size_t i = 0; i < measured.size(); ++i)
    if (const ImageError* error = measured[i].error_against(answer))
      points.push_back({i, {measured[i].frame_ms, measure.value(*error)}});
  return points;
}

std::vector<std::size_t> pareto_front(std::span<const Measurement> measured, Answer answer,
                                      const ErrorMeasure& measure) {
  const auto candidates = points_against(measured, answer, measure);
  std::vector<WorkPrecision> points;
  for (const AnswerPoint& candidate : candidates) points.push_back(candidate.point);
  auto front = pareto_front(points);
  for (std::size_t& i : front) i = candidates[i].index;
  return front;
}

std::optional<std::size_t> cheapest_under(std::span<const Measurement> measured, Answer answer,
                                          const TargetError& target) {
  std::optional<std::size_t> best;
  for (const AnswerPoint& p : points_against(measured, answer, *target.measure))
    if (p.point.error <= target.most && (!best || p.point.ms < measured[*best].frame_ms)) best = p.index;
  return best;
}

std::vector<Convergence> convergence_of(std::span<const Measurement> measured, const TargetError& target) {
  std::vector<Convergence> list;
  for (const Measurement& m : measured)
    for (const AnswerError& e : m.errors) {
      const auto is_this = [&](const Convergence& c) { return c.method == m.method && c.answer == e.answer; };
      if (std::ranges::none_of(list, is_this))
        list.push_back({m.method, e.answer, fit_finest(measured, m.method, e.answer), {}});
    }
  for (Convergence& c : list)
    for (const AnswerPoint& p : points_against(measured, c.answer, *target.measure))
      if (measured[p.index].method == c.method && p.point.error <= target.most &&
          (!c.cheapest || p.point.ms < measured[*c.cheapest].frame_ms))
        c.cheapest = p.index;
  return list;
}

}  // namespace crest
