#include "render/volume/match_values.h"

#include <algorithm>

#include "presets/peaks.h"

namespace crest {
namespace {

constexpr int fine_bins = 65536;

/// y at x on the line through the points; at the first or last one beyond the ends. `xs` ascend strictly.
double interpolated(const std::vector<double>& xs, const std::vector<double>& ys, double x) {
  const auto above = std::ranges::upper_bound(xs, x);
  if (above == xs.begin()) return ys.front();
  if (above == xs.end()) return ys.back();
  const std::size_t i = std::size_t(above - xs.begin());
  return ys[i - 1] + (ys[i] - ys[i - 1]) * ((x - xs[i - 1]) / (xs[i] - xs[i - 1]));
}

double width_ratio(const ValueDistribution& from, const ValueDistribution& to) {
  return with_width(to.range).width() / with_width(from.range).width();
}

/// Gives the spikes' flanks their places about their peaks, within the points beside them.
void place_spikes(TransferFunction& result, const TransferFunction& before, double ratio) {
  auto& points = result.points;
  for (const Peak& peak : find_peaks(before)) {
    if (!peak.spike || !peak.shown) continue;
    const double old_apex = before.points[peak.first_point].value, apex = points[peak.first_point].value;
    const auto place = [&](std::size_t i) { return apex + (before.points[i].value - old_apex) * ratio; };
    for (std::size_t i = peak.left; i < peak.first_point; ++i)
      points[i].value = std::max(place(i), peak.left > 0 ? points[peak.left - 1].value : place(i));
    for (std::size_t i = peak.first_point + 1; i <= peak.right; ++i)
      points[i].value =
          std::min(place(i), peak.right + 1 < points.size() ? points[peak.right + 1].value : place(i));
  }
  for (std::size_t i = 1; i < points.size(); ++i)
    points[i].value = std::max(points[i].value, points[i - 1].value);
}

}  // namespace

ValueDistribution distribution_of(const Volume& volume) {
  const ValueRange range = volume.statistics.range;
  ValueDistribution distribution{range, {}, {}};
  const std::vector<std::uint64_t> counts = histogram_of(volume.values, range, fine_bins);
  std::uint64_t all = 0, below = 0;
  for (const std::uint64_t count : counts) all += count;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    if (counts[i] == 0) continue;
    distribution.value.push_back(range.min + range.width() * (double(i) + 0.5) / fine_bins);
    distribution.share.push_back((double(below) + 0.5 * double(counts[i])) / double(all));
    below += counts[i];
  }
  return distribution;
}

double matched_value(const ValueDistribution& from, const ValueDistribution& to, double value) {
  if (from.value.empty() || to.value.empty()) return value;
  const double ratio = width_ratio(from, to);
  if (value < from.range.min) return to.range.min + (value - from.range.min) * ratio;
  if (value > from.range.max) return to.range.max + (value - from.range.max) * ratio;
  return interpolated(to.share, to.value, interpolated(from.value, from.share, value));
}

TransferFunction carried_by(const TransferFunction& tf, const std::function<double(double)>& map,
                            double width_ratio) {
  TransferFunction result = tf;
  result.plateau_width *= width_ratio;
  for (ControlPoint& point : result.points) point.value = map(point.value);
  place_spikes(result, tf, width_ratio);
  return result;
}

TransferFunction carried(const TransferFunction& tf, const ValueDistribution& from,
                         const ValueDistribution& to, CarryBy by) {
  switch (by) {
    case CarryBy::value:
      return tf;
    case CarryBy::range:
      return remap_values(tf, with_width(from.range), with_width(to.range));
    case CarryBy::histogram:
    case CarryBy::places:
      break;
  }
  return carried_by(
      tf, [&](double value) { return matched_value(from, to, value); }, width_ratio(from, to));
}

}  // namespace crest
