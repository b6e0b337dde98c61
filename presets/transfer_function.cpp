#include "presets/transfer_function.h"

#include <algorithm>
#include <cmath>

namespace crest {
namespace {

Classified at_point(const ControlPoint& point) { return {point.color, point.opacity}; }

Classified mix(const ControlPoint& a, const ControlPoint& b, double t) {
  return {{std::lerp(a.color.r, b.color.r, t), std::lerp(a.color.g, b.color.g, t),
           std::lerp(a.color.b, b.color.b, t)},
          std::lerp(a.opacity, b.opacity, t)};
}

/// On the line from a to b, which have different values. Starting from the nearer of the two keeps the
/// relative accuracy where the line comes down to zero.
Classified between(const ControlPoint& a, const ControlPoint& b, double value) {
  const double from_a = value - a.value, from_b = b.value - value, width = b.value - a.value;
  return from_a <= from_b ? mix(a, b, from_a / width) : mix(b, a, from_b / width);
}

}  // namespace

ValueRange with_width(ValueRange range) {
  return range.width() > 0 ? range : ValueRange{range.min, range.min + 1};
}

ValueRange TransferFunction::range() const {
  return points.empty() ? ValueRange{} : ValueRange{points.front().value, points.back().value};
}

// The last point at a value holds there, so that the TF is continuous from above.
Classified evaluate(const TransferFunction& tf, double value) { return evaluate_right(tf, value); }

Classified evaluate_left(const TransferFunction& tf, double value) {
  if (tf.points.empty() || std::isnan(value)) return {};
  const auto next = std::lower_bound(tf.points.begin(), tf.points.end(), value,
                                     [](const ControlPoint& p, double v) { return p.value < v; });
  if (next == tf.points.end()) return at_point(tf.points.back());
  if (next == tf.points.begin() || next->value == value) return at_point(*next);
  return between(*std::prev(next), *next, value);
}

Classified evaluate_right(const TransferFunction& tf, double value) {
  if (tf.points.empty() || std::isnan(value)) return {};
  const auto next = std::upper_bound(tf.points.begin(), tf.points.end(), value,
                                     [](double v, const ControlPoint& p) { return v < p.value; });
  if (next == tf.points.begin()) return at_point(*next);
  const auto last = std::prev(next);
  if (next == tf.points.end() || last->value == value) return at_point(*last);
  return between(*last, *next, value);
}

double extinction(double opacity, double unit_distance) {
  return -std::log1p(-std::min(opacity, 1 - least_transmittance)) / unit_distance;
}

TransferFunction resolve(const TransferFunction& tf, ValueRange volume_range, double smallest_spacing) {
  TransferFunction resolved = tf.domain == Domain::normalized ? remap_values(tf, {0, 1}, volume_range) : tf;
  resolved.domain = Domain::data;
  if (tf.unit == LengthUnit::voxel) resolved.unit_distance *= smallest_spacing;
  resolved.unit = LengthUnit::world;
  return resolved;
}

TransferFunction remap_values(const TransferFunction& tf, ValueRange from, ValueRange to) {
  from = with_width(from);
  to = with_width(to);
  TransferFunction mapped = tf;
  // lerp is monotonic and exact at both ends: equal values stay equal, and none change places.
  for (ControlPoint& point : mapped.points)
    point.value = std::lerp(to.min, to.max, (point.value - from.min) / from.width());
  mapped.plateau_width = tf.plateau_width / from.width() * to.width();
  return mapped;
}

TransferFunction default_transfer_function() {
  TransferFunction tf;
  tf.domain = Domain::normalized;
  tf.unit = LengthUnit::voxel;
  tf.unit_distance = 8;
  tf.points = {{.value = 0, .color = {0.15, 0.35, 0.85}, .opacity = 0, .surface = {}, .unknown = {}},
               {.value = 1, .color = {1, 0.85, 0.55}, .opacity = 0.5, .surface = {}, .unknown = {}}};
  return tf;
}

}  // namespace crest
