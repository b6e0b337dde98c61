#include "render/measure/method_convergence.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "render/measure/pareto.h"

namespace crest {
namespace {

constexpr std::size_t least_points = 3;

/// A step no longer brings the error down by a third.
bool is_rounding(double rmse, double coarser_rmse) {
  return rmse < rounding_rmse && !(rmse < coarser_rmse / 1.5);
}

/// The largest distance from the power law through the run, in powers of two.
double residual(const OrderFit& fit, std::span<const double> steps, std::span<const double> rmse) {
  double mean = 0, largest = 0;
  const auto offset = [&](std::size_t i) { return std::log2(rmse[i]) - fit.order * std::log2(steps[i]); };
  for (std::size_t i = 0; i < steps.size(); ++i) mean += offset(i) / double(steps.size());
  for (std::size_t i = 0; i < steps.size(); ++i) largest = std::max(largest, std::abs(offset(i) - mean));
  return largest;
}

std::optional<OrderFit> fit_of(const std::string& method, const ExactAnswer& answer,
                               std::span<const Measurement> measured) {
  std::vector<std::pair<double, double>> points;
  for (const Measurement& m : measured)
    if (const ImageError* error = m.error_against(answer); m.method == method && m.step > 0 && error)
      points.emplace_back(m.step, error->compared.rmse);
  std::ranges::sort(points, std::greater{});
  std::vector<double> steps, rmse;
  for (const auto& [step, error] : points) {
    steps.push_back(step);
    rmse.push_back(error);
  }
  return fit_finest_order(steps, rmse);
}

void find_target(MethodConvergence& c, std::span<const Measurement> measured, const TargetError& target) {
  c.cheapest = cheapest_under(measured, c.answer, target, c.method);
  for (const Measurement& m : measured)
    if (const ImageError* error = m.error_against(c.answer);
        c.cheapest && m.method == c.method && m.step < measured[*c.cheapest].step && error)
      c.steady = c.steady && target.is_met(*error);
}

}  // namespace

std::optional<OrderFit> fit_finest_order(std::span<const double> steps, std::span<const double> rmse) {
  std::size_t end = rmse.size();
  while (end > 1 && is_rounding(rmse[end - 1], rmse[end - 2])) --end;
  const std::size_t last_end = std::max(least_points, end - std::min<std::size_t>(end, 1));
  for (; end >= last_end; --end)
    for (std::size_t count = end; count >= least_points; --count) {
      const auto run_steps = steps.subspan(end - count, count), run_rmse = rmse.subspan(end - count, count);
      const auto fit = fit_order(run_steps, run_rmse, 0, int(count));
      if (fit && residual(*fit, run_steps, run_rmse) <= order_residual) return fit;
    }
  return std::nullopt;
}

std::vector<MethodConvergence> convergence_of(std::span<const Measurement> measured,
                                              const TargetError& target) {
  std::vector<MethodConvergence> list;
  for (const Measurement& m : measured)
    for (const auto& [answer, error] : m.errors) {
      const auto is_this = [&](const auto& c) { return c.method == m.method && c.answer == answer; };
      if (std::ranges::none_of(list, is_this))
        list.push_back({m.method, answer, fit_of(m.method, answer, measured), {}});
    }
  for (MethodConvergence& c : list) find_target(c, measured, target);
  return list;
}

}  // namespace crest
