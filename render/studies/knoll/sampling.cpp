#include "render/studies/knoll/sampling.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "render/studies/knoll/variants.h"

namespace crest {
namespace {

constexpr double step_precision = 1.02, time_tolerance = 0.03;
constexpr int time_turns = 5, timed_pairs = 3;

Variant uniform(const Variant& method, double step) {
  return {"uniform", fmt::format("{}, equal steps of {:.3g}", method.name, step),
          fmt::format("{} sampling=uniform step={}", method.settings, step), method.peak_gain};
}

}  // namespace

std::optional<double> longest_step_within(double most_error, const std::function<double(double)>& error,
                                          double shortest, double longest) {
  const auto does = [&](double step) { return error(step) <= most_error; };
  double good = std::clamp(1.0, shortest, longest);
  if (does(good)) {
    while (good < longest && does(std::min(2 * good, longest))) good = std::min(2 * good, longest);
    if (good >= longest) return longest;
  } else {
    do {
      if (good <= shortest) return std::nullopt;
      good = std::max(good / 2, shortest);
    } while (!does(good));
  }
  double bad = std::min(2 * good, longest);
  while (bad / good > step_precision) {
    const double middle = std::sqrt(good * bad);
    (does(middle) ? good : bad) = middle;
  }
  return good;
}

double step_of_equal_cost(double first, const std::function<double(double)>& ratio, double tolerance,
                          int turns, double shortest, double longest) {
  double step = std::clamp(first, shortest, longest), best = step, least = HUGE_VAL;
  for (int turn = 0; turn < turns && least > tolerance; ++turn) {
    const double r = ratio(step), off = std::abs(std::log(r));
    if (off < least) {
      least = off;
      best = step;
    }
    step = std::clamp(step * r, shortest, longest);
  }
  return best;
}

std::string sampling_group_id(HeldConstant held, std::string_view scene, std::string_view method) {
  return fmt::format("{}-{}-{}", scene, method, held == HeldConstant::quality ? "quality" : "frame-rate");
}

SamplingRow compare_sampling(KnollLab& lab, const KnollScene& scene, HeldConstant held, const Variant& method,
                             bool with_pictures) {
  SamplingRow row{held, scene.id, method.id, {}, {}, true};
  const Variant differential{
      "differential", method.name + ", differential",
      fmt::format("{} sampling=differential s_k={}", method.settings, s_k_of_paper(lab.settings().size.x)),
      method.peak_gain};
  const Shot wanted = lab.shoot(scene, differential, with_pictures);
  double step = 1;
  if (held == HeldConstant::quality) {
    const auto error = [&](double s) { return lab.rmse(scene, uniform(method, s)); };
    const auto found =
        longest_step_within(wanted.error.compared.rmse, error, shortest_uniform_step, longest_uniform_step);
    row.reached = found.has_value();
    step = found.value_or(shortest_uniform_step);
  } else {
    const RenderCounts counts = lab.counts(scene, uniform(method, 1));
    const double first = counts.samples / counts.pixels / wanted.samples_per_ray;
    const auto ratio = [&](double s) {
      return lab.time_ratio(scene, uniform(method, s), differential, timed_pairs);
    };
    step = step_of_equal_cost(first, ratio, time_tolerance, time_turns, shortest_uniform_step,
                              longest_uniform_step);
  }
  row.shots = {sampling_group_id(held, scene.id, method.id), method.name, scene.id, {}};
  row.shots.shots = {lab.shoot(scene, uniform(method, step), with_pictures), wanted};
  lab.time(scene, row.shots.shots);
  return row;
}

}  // namespace crest
