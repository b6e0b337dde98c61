#include "ui/shown_values.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "presets/number_text.h"
#include "ui/value_axis.h"

namespace crest {
namespace {

constexpr double seen = 1e-5;  ///< of the range: no pixel is so narrow at rest

/// The distance to the nearest other value.
double gap_at(const std::vector<double>& sorted, double value) {
  const auto from = std::ranges::lower_bound(sorted, value), to = std::ranges::upper_bound(sorted, value);
  double gap = std::numeric_limits<double>::infinity();
  if (from != sorted.begin()) gap = value - *(from - 1);
  if (to != sorted.end()) gap = std::min(gap, *to - value);
  return gap;
}

}  // namespace

TransferFunction shown_values(const TransferFunction& stored, Domain shown, ValueRange volume) {
  TransferFunction tf = in_domain(stored, shown, volume);
  std::vector<double> values;
  for (const ControlPoint& point : tf.points) values.push_back(point.value);
  std::ranges::sort(values);
  const double width = range_in_domain(tf, volume).width();
  for (ControlPoint& point : tf.points) {
    const double resolution = std::min(seen * width, 1e-3 * gap_at(values, point.value));
    if (resolution > 0) point.value = round_to_resolution(point.value, resolution);
  }
  return tf;
}

TransferFunction stored_values(const TransferFunction& edited, const TransferFunction& stored,
                               ValueRange volume) {
  const TransferFunction shown = shown_values(stored, edited.domain, volume);
  TransferFunction tf = in_domain(edited, stored.domain, volume);
  const double scale =
      std::max(std::abs(range_in_domain(stored, volume).min), std::abs(range_in_domain(stored, volume).max));
  for (std::size_t i = 0; i < tf.points.size(); ++i) {
    const double edited_value = edited.points[i].value;
    const auto same = std::ranges::lower_bound(shown.points, edited_value, {}, &ControlPoint::value);
    double& value = tf.points[i].value;
    if (same != shown.points.end() && same->value == edited_value)
      value = stored.points[std::size_t(same - shown.points.begin())].value;
    else
      value = without_noise(value, scale);
  }
  if (edited.plateau_width == shown.plateau_width) tf.plateau_width = stored.plateau_width;
  return tf;
}

}  // namespace crest
