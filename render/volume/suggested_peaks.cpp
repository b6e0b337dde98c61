#include "render/volume/suggested_peaks.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

namespace crest {
namespace {

constexpr double least_share = 1e-5;  // of the volume

std::vector<double> smoothed(const std::vector<double>& values) {
  static constexpr std::array<double, 5> weight{1. / 16, 4. / 16, 6. / 16, 4. / 16, 1. / 16};
  std::vector<double> result(values.size());
  for (std::size_t i = 0; i < values.size(); ++i)
    for (std::size_t k = 0; k < weight.size(); ++k)
      if (i + k >= 2 && i + k - 2 < values.size()) result[i] += weight[k] * values[i + k - 2];
  return result;
}

/// The curve's bins that count, by ascending value.
struct Curve {
  std::vector<double> value, gradient;
};

Curve gradient_curve(const ByValue& by_value) {
  const double whole = std::accumulate(by_value.volume.begin(), by_value.volume.end(), 0.0);
  const std::vector<double> volume = smoothed(by_value.volume), gradient = smoothed(by_value.gradient);
  Curve curve;
  for (std::size_t i = 0; i < volume.size(); ++i)
    if (by_value.volume[i] > 0 && volume[i] > least_share * whole) {
      curve.value.push_back(by_value.middle(i));
      curve.gradient.push_back(gradient[i] / volume[i]);
    }
  return curve;
}

struct Maximum {
  std::size_t at;
  double persistence;
};

/// Adds the places from the highest down, and joins neighbours that are there: where two hills meet, the
/// lower one ends.
std::vector<Maximum> maxima_of(const std::vector<double>& height) {
  constexpr std::size_t none = std::size_t(-1);
  std::vector<std::size_t> order(height.size()), hill(height.size(), none);
  std::iota(order.begin(), order.end(), 0U);
  std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) { return height[a] > height[b]; });
  const auto top_of = [&](std::size_t i) {  // each place points to a higher one of its hill
    while (hill[i] != i) i = hill[i] = hill[hill[i]];
    return i;
  };
  std::vector<Maximum> maxima;
  for (const std::size_t i : order) {
    hill[i] = i;
    for (const std::size_t neighbour : {i - 1, i + 1}) {  // i - 1 of 0 is none of them
      if (neighbour >= height.size() || hill[neighbour] == none) continue;
      std::size_t a = top_of(i), b = top_of(neighbour);
      if (height[a] < height[b]) std::swap(a, b);
      if (b != i && height[b] > height[i]) maxima.push_back({b, height[b] - height[i]});
      hill[b] = a;
    }
  }
  if (!order.empty()) maxima.push_back({order.front(), height[order.front()] - height[order.back()]});
  return maxima;
}

/// Where the parabola through a maximum and its neighbours is highest.
double refined(const Curve& curve, std::size_t i) {
  if (i == 0 || i + 1 >= curve.value.size()) return curve.value[i];
  const double below = curve.gradient[i - 1], at = curve.gradient[i], above = curve.gradient[i + 1];
  const double left = curve.value[i] - curve.value[i - 1], right = curve.value[i + 1] - curve.value[i];
  const double bend = below - 2 * at + above;
  if (left != right || bend >= 0) return curve.value[i];  // a gap between them
  return curve.value[i] + std::clamp((below - above) / (2 * bend), -0.5, 0.5) * left;
}

}  // namespace

std::vector<SuggestedPeak> suggest_peaks(const ByValue& by_value, double least) {
  const Curve curve = gradient_curve(by_value);
  std::vector<SuggestedPeak> peaks;
  if (curve.value.empty()) return peaks;
  const double highest = *std::ranges::max_element(curve.gradient);
  if (!(highest > 0)) return peaks;
  for (const Maximum& maximum : maxima_of(curve.gradient))
    if (maximum.persistence >= least * highest)
      peaks.push_back(
          {refined(curve, maximum.at), curve.gradient[maximum.at], maximum.persistence / highest});
  std::ranges::stable_sort(peaks, [](const SuggestedPeak& a, const SuggestedPeak& b) {
    return a.persistence > b.persistence || (a.persistence == b.persistence && a.value < b.value);
  });
  return peaks;
}

}  // namespace crest
