#include "render/studies/placement/plane_placement.h"

#include <algorithm>
#include <cmath>

#include "presets/names.h"
#include "render/studies/placement/segments.h"

namespace crest {
namespace {

constexpr double rounding = 1e-12;  ///< of the sums in double

/// A square as a fan sees it.
struct View {
  const Square& square;
  std::vector<std::optional<PlaneRay>> rays;
  std::vector<double> exact;

  View(const Square& s, int count) : square(s), rays(fan(count)) {
    for (const auto& ray : rays) exact.push_back(ray ? exact_intensity(square, *ray) : 0);
  }
};

std::vector<double> intensities(const View& view, Placement placement, double step, Sum sum) {
  std::vector<double> result;
  for (const auto& ray : view.rays)
    result.push_back(ray ? intensity(view.square, *ray, placement, step, sum) : 0);
  return result;
}

PlaneErrors errors_of(const View& view, const std::vector<double>& found, Placement placement, double step) {
  PlaneErrors errors;
  double squares = 0;
  for (std::size_t i = 0; i < view.rays.size(); ++i) {
    if (!view.rays[i]) continue;
    const double error = found[i] - view.exact[i];
    errors.least = std::min(errors.least, error);
    errors.greatest = std::max(errors.greatest, error);
    squares += error * error;
    errors.unsampled += segments_of(placement, step, view.rays[i]->enter, view.rays[i]->exit).n == 0;
    ++errors.rays;
  }
  errors.max = std::max(-errors.least, errors.greatest);
  errors.rms = std::sqrt(squares / errors.rays);
  return errors;
}

std::optional<OrderFit> order_of(const PlaneSeries& series, double PlaneErrors::*error) {
  std::vector<double> steps, errors;
  for (const PlaneMeasurement& m : series.measurements) {
    steps.push_back(1.0 / m.rate);
    errors.push_back(m.dense_errors.*error);
  }
  return fit_order(steps, errors, rounding, int(study_rates.size()));
}

PlaneSeries make_series(const View& view, const View& dense_view, PlaneSeries series) {
  for (const int rate : study_rates) {
    const double step = Square::spacing / rate;
    PlaneMeasurement m{rate, intensities(view, series.placement, step, series.sum), {}, {}};
    m.errors = errors_of(view, m.intensities, series.placement, step);
    const auto many = intensities(dense_view, series.placement, step, series.sum);
    m.dense_errors = errors_of(dense_view, many, series.placement, step);
    series.measurements.push_back(std::move(m));
  }
  series.max_order = order_of(series, &PlaneErrors::max);
  series.rms_order = order_of(series, &PlaneErrors::rms);
  return series;
}

}  // namespace

std::string_view name_of(Sum sum) { return sum == Sum::paper ? "paper" : "absorbing"; }

double intensity(const Square& square, const PlaneRay& ray, Placement placement, double step, Sum sum) {
  const Segments segments = segments_of(placement, step, ray.enter, ray.exit);
  double result = 0, transmittance = 1;
  for (int i = 0; i < segments.n; ++i) {
    const double emitted = square.value(ray.at(segments.middle(i))) * segments.size;  // g dx
    const double alpha = -std::expm1(-emitted / 2);                                   // 1 - exp(-tau dx)
    result += transmittance * (sum == Sum::paper ? emitted : 2 * alpha);
    transmittance *= 1 - alpha;
  }
  return result;
}

PlaneStudy study_plane() {
  PlaneStudy study;
  const std::pair<std::string_view, Square> fields[] = {{"linear", linear_square()},
                                                        {"curved", curved_square()}};
  for (const auto& [name, square] : fields) {
    const View view(square, paper_rays), dense_view(square, dense * paper_rays);
    study.fields.push_back({name, view.exact});
    for (const Sum sum : {Sum::paper, Sum::absorbing})
      for (const auto& [placement, placement_name] : names_of<Placement>())
        study.series.push_back(make_series(view, dense_view, {name, sum, placement, {}, {}, {}}));
  }
  return study;
}

}  // namespace crest
