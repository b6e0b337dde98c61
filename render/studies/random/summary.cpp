#include "render/studies/random/summary.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "render/measure/convergence.h"
#include "render/measure/method_convergence.h"

namespace crest {
namespace {

void add(StepSummary& sum, const RandomMeasurement& m) {
  const PixelErrors& compared = m.error.compared;
  const double pixels = double(compared.pixels), all = sum.pixels + pixels;
  if (pixels == 0) return;
  ++sum.scenes;
  const double squares = sum.rmse * sum.rmse * sum.pixels + compared.rmse * compared.rmse * pixels;
  sum.rmse = std::sqrt(squares / all);
  sum.pixels = all;
  sum.wrong += double(m.wrong);
  sum.outliers += double(m.outliers);
  sum.max = std::max(sum.max, compared.max);
  if (const double within = 1 - double(m.wrong) / pixels; sum.worst_scene < 0 || within < sum.worst_within) {
    sum.worst_within = within;
    sum.worst_scene = m.scene;
  }
  if (!m.error.crossings) return;
  if (!sum.crossings) sum.crossings.emplace();
  sum.crossings->exact += m.error.crossings->exact;
  sum.crossings->missed += m.error.crossings->missed;
  sum.crossings->invented += m.error.crossings->invented;
}

std::vector<std::optional<double>> orders_of(const std::vector<StepSummary>& steps) {
  std::vector<std::optional<double>> orders;
  for (std::size_t i = 1; i < steps.size(); ++i) {
    const double sizes[] = {steps[i - 1].step, steps[i].step}, errors[] = {steps[i - 1].rmse, steps[i].rmse};
    const auto fit = fit_order(sizes, errors, rounding_rmse, 2);
    orders.push_back(fit ? std::optional(fit->order) : std::nullopt);
  }
  return orders;
}

}  // namespace

double StepSummary::within() const {
  return pixels > 0 ? 1 - wrong / pixels : std::numeric_limits<double>::quiet_NaN();
}

std::vector<MethodSummary> summarize(std::span<const RandomMeasurement> measurements,
                                     const std::function<bool(int scene)>& is_asked_for) {
  std::vector<MethodSummary> list;
  for (const RandomMeasurement& m : measurements) {
    if (!is_asked_for(m.scene)) continue;
    auto summary = std::ranges::find_if(
        list, [&](const MethodSummary& s) { return s.method == m.method && s.answer == m.answer; });
    if (summary == list.end()) summary = list.insert(list.end(), {m.method, m.answer, {}, {}});
    auto& steps = summary->steps;
    const auto at = std::ranges::lower_bound(steps, m.step, std::greater{}, &StepSummary::step);
    add(at != steps.end() && at->step == m.step
            ? *at
            : *steps.insert(at, StepSummary{.step = m.step, .crossings = {}}),
        m);
  }
  for (MethodSummary& summary : list) summary.orders = orders_of(summary.steps);
  return list;
}

const MethodSummary* best_sampled(std::span<const MethodSummary> summaries) {
  const MethodSummary* best = nullptr;
  const auto is_better = [](const MethodSummary& a, const MethodSummary& b) {
    return std::ranges::lexicographical_compare(a.steps.rbegin(), a.steps.rend(), b.steps.rbegin(),
                                                b.steps.rend(), std::greater{}, &StepSummary::within,
                                                &StepSummary::within);
  };
  for (const MethodSummary& s : summaries)
    if (s.answer == ExactAnswer(Answer::base_and_crossings) && s.steps.back().step > 0 &&
        (!best || is_better(s, *best)))
      best = &s;
  return best;
}

const MethodSummary* find_summary(std::span<const MethodSummary> summaries, std::string_view method) {
  const auto found = std::ranges::find(summaries, method, &MethodSummary::method);
  return found == summaries.end() ? nullptr : &*found;
}

}  // namespace crest
