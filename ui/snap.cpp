#include "ui/snap.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "presets/peaks.h"

namespace crest {

std::vector<double> histogram_maxima(const VolumeStatistics& statistics) {
  constexpr std::size_t group = 8;  // bins that count together, against noise
  constexpr double least_prominence = 0.15;
  const auto& counts = statistics.histogram;
  const auto total = [&](std::size_t first) {
    return std::accumulate(counts.begin() + std::ptrdiff_t(first),
                           counts.begin() + std::ptrdiff_t(std::min(first + group, counts.size())),
                           std::uint64_t(0));
  };
  TransferFunction heights;  // whose peaks are the maxima
  heights.min_prominence = least_prominence;
  std::uint64_t largest = 1;
  for (std::size_t first = 0; first < counts.size(); first += group)
    largest = std::max(largest, total(first));
  heights.points.emplace_back();  // the first and the last bin can be maxima, too
  for (std::size_t first = 0; first < counts.size(); first += group) {
    ControlPoint& point = heights.points.emplace_back();
    point.value = double(first);
    point.opacity = std::log1p(double(total(first))) / std::log1p(double(largest));
  }
  heights.points.emplace_back().value = double(counts.size());
  std::vector<double> maxima;
  for (const Peak& peak : find_peaks(heights)) {
    const auto begin = counts.begin() + std::ptrdiff_t(heights.points[peak.first_point].value);
    const auto bin = std::max_element(begin, begin + std::min(std::ptrdiff_t(group), counts.end() - begin)) -
                     counts.begin();
    maxima.push_back(statistics.range.min +
                     statistics.range.width() * (double(bin) + 0.5) / double(counts.size()));
  }
  return maxima;
}

std::vector<double> snap_places(const std::vector<ControlPoint>& points, const Selection& moving,
                                std::span<const double> landmarks, const ValueAxis& axis) {
  std::vector<double> places(landmarks.begin(), landmarks.end());
  for (std::size_t i = 0; i < points.size(); ++i)
    if (!std::binary_search(moving.begin(), moving.end(), i)) places.push_back(points[i].value);
  for (const AxisTicks::Tick& tick : axis_ticks(axis.visible, 20).ticks) places.push_back(tick.value);
  return places;
}

std::optional<double> snapped(double value, double reach, std::span<const double> places) {
  std::optional<double> nearest;
  for (const double place : places)
    if (std::abs(place - value) <= (nearest ? std::abs(*nearest - value) : reach)) nearest = place;
  return nearest;
}

}  // namespace crest
