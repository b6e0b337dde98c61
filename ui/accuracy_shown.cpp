#include "ui/accuracy_shown.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "render/measure/pareto.h"
#include "ui/widgets.h"

namespace crest {
namespace {

/// The lookup takes a millisecond or so, hence once for each setting.
const Method* method_of(const Rendering& rendering, const Rendering& base, AccuracyState& state) {
  if (state.present && state.present->rendering == rendering) return state.present->method;
  const auto found = std::ranges::find_if(methods(), [&](const Method& method) {
    return with_method(base, method, rendering.step) == rendering;
  });
  state.present = {rendering, found == methods().end() ? nullptr : &*found};
  return state.present->method;
}

}  // namespace

WorkPrecision ShownAccuracy::point_of(std::size_t measured) const {
  const Measurement& m = results.measured[measured];
  return {m.frame_ms, target.measure->value(*m.error_against(answer))};
}

ShownAccuracy shown_accuracy(const AccuracyResults& results, AccuracyState& state,
                             const Rendering& rendering) {
  ShownAccuracy shown{results, state.answer.value_or(exact_answers_of(rendering).front()), state.target};
  const auto& measured = results.measured;
  if (measured.empty()) return shown;
  const ErrorMeasure& measure = *shown.target.measure;
  shown.lines = method_lines(measured, shown.answer, measure);
  for (const std::size_t i : pareto_front(measured, shown.answer, measure))
    shown.front.push_back(shown.point_of(i));
  shown.recommended = cheapest_under(measured, shown.answer, shown.target);
  for (MethodConvergence& convergence : convergence_of(measured, shown.target))
    if (convergence.answer == shown.answer) shown.convergences.push_back(std::move(convergence));
  shown.base = with_filters_of(rendering, results.rendering);
  shown.present = method_of(rendering, shown.base, state);
  for (const MethodLine& line : shown.lines)
    if (line.method == shown.present) shown.present_point = point_at_step(line, measured, rendering.step);
  return shown;
}

std::string verdict_text(const ShownAccuracy& shown) {
  const auto text_of = [&](std::size_t i) {
    const Measurement& m = shown.results.measured[i];
    const Method* method = find_method(m.method);
    const std::string name(method ? method->name : std::string_view(m.method));
    return m.step > 0 ? fmt::format("{} at step {}", name, step_text(m.step)) : name;
  };
  if (shown.recommended)
    return fmt::format("Fastest that keeps {}: {}, {} ms", to_string(shown.target),
                       text_of(*shown.recommended), ms_text(shown.point_of(*shown.recommended).ms));
  const auto points = points_against(shown.results.measured, shown.answer, *shown.target.measure);
  if (shown.lines.empty() || points.empty()) return "";
  const auto closest = std::ranges::min_element(
      points, {}, [](const AnswerPoint& p) { return std::isnan(p.point.error) ? HUGE_VAL : p.point.error; });
  return fmt::format("No setting measured{} keeps {}: the closest is {} ({} {:.3g})",
                     shown.results.is_running ? " so far" : "", to_string(shown.target),
                     text_of(closest->index), shown.target.measure->id, closest->point.error);
}

std::string step_text(double step) {
  const double parts = 1 / step;
  return step < 1 && parts == std::round(parts) ? fmt::format("1/{}", parts) : short_text(step);
}

std::string ms_text(double ms) { return ms < 100 ? fmt::format("{:.3g}", ms) : fmt::format("{:.0f}", ms); }

bool apply_setting(Document& document, AccuracyState& state, const ShownAccuracy& shown,
                   std::size_t measured) {
  const Measurement& m = shown.results.measured[measured];
  const Method* method = find_method(m.method);
  if (!method) return false;
  state.answer = shown.answer;  // stays, whatever mode the document takes
  const Rendering before = document.preset.rendering;
  document.preset.rendering = with_method(shown.base, *method, m.step);
  return document.preset.rendering != before;
}

}  // namespace crest
