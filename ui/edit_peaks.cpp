#include "ui/edit_peaks.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace crest {
namespace {

Selection from_to(std::size_t first, std::size_t last) {
  Selection points(last - first + 1);
  std::iota(points.begin(), points.end(), first);
  return points;
}

/// Whether a point changes nothing: it lies on the curve that there is without it.
bool is_redundant(const TransferFunction& tf, std::size_t point) {
  const ControlPoint& p = tf.points[point];
  TransferFunction rest = tf;
  erase_points(rest, {point});
  if (rest.points.empty() || p.value < rest.range().min || p.value > rest.range().max) return false;
  const Classified low = evaluate_left(rest, p.value), high = evaluate_right(rest, p.value);
  const auto is_same = [&](const Classified& c) {
    const glm::dvec3 off = c.color - p.color;
    return std::abs(c.opacity - p.opacity) + std::abs(off.r) + std::abs(off.g) + std::abs(off.b) < 1e-9;
  };
  return is_same(low) || is_same(high);
}

}  // namespace

Selection top_of(const Peak& peak) { return from_to(peak.first_point, peak.last_point); }

void show_peak(TransferFunction& tf, const Peak& peak, bool shown) {
  const SurfaceMode visible = peak.detected ? SurfaceMode::automatic : SurfaceMode::on;
  for (const std::size_t i : top_of(peak)) tf.points[i].surface.mode = shown ? visible : SurfaceMode::off;
}

void show_only(TransferFunction& tf, std::span<const Peak> peaks, std::size_t index) {
  bool alone = peaks[index].shown;
  for (std::size_t i = 0; i < peaks.size(); ++i) alone &= i == index || !peaks[i].shown;
  for (std::size_t i = 0; i < peaks.size(); ++i) {
    const bool shown = alone || i == index;
    if (peaks[i].shown != shown) show_peak(tf, peaks[i], shown);
  }
}

void erase_peak(TransferFunction& tf, const Peak& peak) {
  if (!peak.detected) return erase_points(tf, top_of(peak));
  const PointRange shape = points_of(tf, peak);
  if (shape.last - shape.first > 1) erase_points(tf, from_to(shape.first + 1, shape.last - 1));
  if (is_redundant(tf, shape.first + 1)) erase_points(tf, {shape.first + 1});
  if (is_redundant(tf, shape.first)) erase_points(tf, {shape.first});
}

Selection duplicate_peak(TransferFunction& tf, const Peak& peak, double value) {
  const PointRange shape =
      peak.detected ? points_of(tf, peak) : PointRange{peak.first_point, peak.last_point};
  const Selection moving = from_to(shape.first, shape.last);
  const Moved elsewhere = moved(tf, moving, peak.first_point, value, Neighbours::free);
  std::vector<ControlPoint> all = tf.points;
  for (const std::size_t i : moving) all.push_back(elsewhere.points[elsewhere.now_at[i]]);
  const Moved result = in_order(all);
  const std::size_t offset = tf.points.size() - shape.first;  // of a copy from its original
  Selection top;
  for (const std::size_t i : top_of(peak)) top.push_back(i + offset);
  tf.points = result.points;
  return result.of(top);
}

}  // namespace crest
