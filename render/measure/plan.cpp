#include "render/measure/plan.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "render/measure/pareto.h"

namespace crest {
namespace {

constexpr std::array steps{4.0, 2.0, 1.0, 0.5, 0.25, 0.125, 1.0 / 16, 1.0 / 32, 1.0 / 64};
constexpr std::array coverage_steps{4.0, 1.0, 0.25};

/// A forecast is trusted to within this factor where a point is put off because of it.
constexpr double trust = 4;

double distance(double step, double other) { return std::abs(std::log(step / other)); }

std::vector<const Measurement*> of_method(std::string_view method, std::span<const Measurement> measured) {
  std::vector<const Measurement*> own;
  for (const Measurement& m : measured)
    if (m.method == method) own.push_back(&m);
  return own;
}

bool is_measured(std::string_view method, double step, std::span<const Measurement> measured) {
  return std::ranges::any_of(measured, [&](const auto& m) { return m.method == method && m.step == step; });
}

std::vector<double> steps_of(const Method& method) {
  return method.has_step ? std::vector(steps.begin(), steps.end()) : std::vector{0.0};
}

bool covers(const Method& method, double step) {
  return !method.has_step || std::ranges::find(coverage_steps, step) != coverage_steps.end();
}

/// The step whose measurement says most about where a method begins to meet the target: the middle one
/// between the finest coarser step that misses it and the coarsest that meets it, or two steps finer than all
/// so far. Nothing where that is known, or not to be expected on the whole ladder.
std::optional<double> step_towards_target(const Method& method, const ExactAnswer& answer,
                                          const TargetError& target, std::span<const Measurement> measured) {
  double coarsest_met = 0, finest = 1e9;
  for (const Measurement* m : of_method(method.id, measured)) {
    const ImageError* error = m->error_against(answer);
    if (!error) continue;
    finest = std::min(finest, m->step);
    if (target.is_met(*error)) coarsest_met = std::max(coarsest_met, m->step);
  }
  if (finest > 1e8) return std::nullopt;
  std::vector<double> between;
  for (auto step = steps.rbegin(); step != steps.rend(); ++step) {  // from fine to coarse
    if (*step <= coarsest_met) continue;
    if (coarsest_met == 0 && *step >= finest) break;
    if (coarsest_met > 0 && is_measured(method.id, *step, measured)) break;
    between.push_back(*step);
  }
  if (between.empty()) return std::nullopt;
  if (coarsest_met > 0) return between[between.size() / 2];
  const auto at_best = expected_error(method.id, steps.back(), answer, *target.measure, measured);
  if (at_best && *at_best > trust * target.most) return std::nullopt;
  return between[between.size() - std::min<std::size_t>(2, between.size())];
}

/// The exact answers that a method was measured against.
std::vector<ExactAnswer> answers_of(const Method& method, std::span<const Measurement> measured) {
  std::vector<ExactAnswer> answers;
  for (const Measurement* m : of_method(method.id, measured))
    for (const AnswerError& error : m->errors)
      if (std::ranges::find(answers, error.answer) == answers.end()) answers.push_back(error.answer);
  return answers;
}

bool leads_to_target(const Method& method, double step, const TargetError& target,
                     std::span<const Measurement> measured) {
  return method.has_step && std::ranges::any_of(answers_of(method, measured), [&](const ExactAnswer& answer) {
           return step_towards_target(method, answer, target, measured) == step;
         });
}

/// Whether its next coarser or finer step is on a front.
bool is_beside_front(const Method& method, double step, const TargetError& target,
                     std::span<const Measurement> measured) {
  return std::ranges::any_of(answers_of(method, measured), [&](const ExactAnswer& answer) {
    return std::ranges::any_of(pareto_front(measured, answer, *target.measure), [&](std::size_t i) {
      return measured[i].method == method.id && distance(measured[i].step, step) < 1;
    });
  });
}

/// Whether for all its answers a measured point is as fast and much closer than can be expected of it.
bool is_dominated(const PlannedPoint& planned, const TargetError& target,
                  std::span<const Measurement> measured) {
  const auto answers = answers_of(*planned.method, measured);
  return !answers.empty() && std::ranges::all_of(answers, [&](const ExactAnswer& answer) {
    const auto error = expected_error(planned.method->id, planned.step, answer, *target.measure, measured);
    if (!error || !planned.expected_ms) return false;
    return std::ranges::any_of(points_against(measured, answer, *target.measure), [&](const AnswerPoint& p) {
      return measured[p.index].method != planned.method->id && p.point.ms <= *planned.expected_ms &&
             trust * p.point.error <= *error;
    });
  });
}

Why why_to_measure(const PlannedPoint& planned, const TargetError& target,
                   std::span<const Measurement> measured) {
  const Method& method = *planned.method;
  if (covers(method, planned.step)) return Why::coverage;
  if (leads_to_target(method, planned.step, target, measured)) return Why::target;
  if (is_dominated(planned, target, measured)) return Why::dominated;
  return is_beside_front(method, planned.step, target, measured) ? Why::front : Why::rest;
}

}  // namespace

std::span<const double> sweep_steps() { return steps; }

std::optional<double> expected_frame_ms(std::string_view method, double step,
                                        std::span<const Measurement> measured) {
  const auto own = of_method(method, measured);
  if (!own.empty()) {
    const auto nearest =
        *std::ranges::min_element(own, {}, [&](const Measurement* m) { return distance(m->step, step); });
    return nearest->frame_ms * (step > 0 ? std::max(1.0, nearest->step / step) : 1.0);
  }
  std::optional<double> slowest;
  for (const Measurement& m : measured)
    if (const auto ms = m.method == method ? std::nullopt : expected_frame_ms(m.method, step, measured))
      slowest = std::max(slowest.value_or(0), *ms);
  return slowest;
}

std::optional<double> expected_error(std::string_view method, double step, const ExactAnswer& answer,
                                     const ErrorMeasure& measure, std::span<const Measurement> measured) {
  struct Point {
    double step, error;
  };
  std::vector<Point> points;
  for (const Measurement* m : of_method(method, measured))
    if (const ImageError* error = m->error_against(answer); error && m->step > 0 && measure.value(*error) > 0)
      points.push_back({m->step, measure.value(*error)});
  if (points.size() < 2) return std::nullopt;
  std::ranges::sort(points, {}, [&](const Point& p) { return distance(p.step, step); });
  const double order =
      std::log(points[0].error / points[1].error) / std::log(points[0].step / points[1].step);
  return points[0].error * std::pow(step / points[0].step, order);
}

std::vector<PlannedPoint> plan_points(std::span<const Method* const> methods,
                                      std::span<const Measurement> measured, const TargetError& target) {
  std::vector<PlannedPoint> points;
  for (const Method* method : methods)
    for (const double step : steps_of(*method)) {
      if (is_measured(method->id, step, measured)) continue;
      PlannedPoint point{method, step, Why::rest, expected_frame_ms(method->id, step, measured)};
      point.why = why_to_measure(point, target, measured);
      points.push_back(point);
    }
  std::ranges::stable_sort(points, {}, [](const PlannedPoint& p) {
    const double cost = p.why == Why::coverage ? -p.step : p.expected_ms.value_or(0);
    return std::pair(p.why, cost);
  });
  return points;
}

}  // namespace crest
