#include "ui/edit_points.h"

#include <algorithm>
#include <cmath>

#include "presets/number_text.h"

namespace crest {
namespace {

/// The first point above `value`.
std::size_t place_after(const std::vector<ControlPoint>& points, double value) {
  return std::size_t(std::upper_bound(points.begin(), points.end(), value,
                                      [](double v, const ControlPoint& p) { return v < p.value; }) -
                     points.begin());
}

void insert_at(TransferFunction& tf, std::size_t place, std::initializer_list<ControlPoint> points) {
  tf.points.insert(tf.points.begin() + std::ptrdiff_t(place), points);
}

}  // namespace

bool is_selected(const Selection& selection, std::size_t point) {
  return std::binary_search(selection.begin(), selection.end(), point);
}

ControlPoint point_at(double value, const Classified& curve) {
  const auto tidy = [](double v) { return std::clamp(without_noise(v, std::abs(v)), 0.0, 1.0); };
  ControlPoint point;
  point.value = value;
  point.color = {tidy(curve.color.r), tidy(curve.color.g), tidy(curve.color.b)};
  point.opacity = tidy(curve.opacity);
  return point;
}

std::size_t insert_point(TransferFunction& tf, double value, double opacity) {
  ControlPoint point = point_at(value, evaluate(tf, value));
  if (tf.points.empty()) point.color = glm::dvec3(1);
  point.opacity = std::clamp(opacity, 0.0, 1.0);
  const std::size_t place = place_after(tf.points, value);
  insert_at(tf, place, {point});
  return place;
}

std::size_t insert_peak(TransferFunction& tf, double value, double opacity, double width, glm::dvec3 color) {
  const std::size_t place = place_after(tf.points, value);
  double left = value - width / 2, right = value + width / 2;
  if (place > 0) left = std::max(left, tf.points[place - 1].value);
  if (place < tf.points.size()) right = std::min(right, tf.points[place].value);
  // With one flank only it would be a step's corner, and no peak.
  if (left == value || right == value) left = right = value;
  const ControlPoint apex = point_at(value, {color, opacity});
  insert_at(tf, place,
            {point_at(left, evaluate_right(tf, left)), apex, point_at(right, evaluate_left(tf, right))});
  return place + 1;
}

double widest_spike(const TransferFunction& tf) {
  return tf.points.empty() ? 0 : tf.spike_width * tf.range().width();
}

double widest_gap(const TransferFunction& tf, ValueRange range) {
  double from = range.min, widest = -1, middle = (range.min + range.max) / 2;
  const auto gap_to = [&](double to) {
    if (to - from > widest) {
      widest = to - from;
      middle = (from + to) / 2;
    }
    from = to;
  };
  for (const ControlPoint& point : tf.points)
    if (point.value > range.min && point.value < range.max) gap_to(point.value);
  gap_to(range.max);
  return middle;
}

std::size_t insert_step(TransferFunction& tf, double value, double opacity) {
  const Classified curve = evaluate(tf, value);
  ControlPoint upper = point_at(value, curve);
  upper.opacity = std::clamp(opacity, 0.0, 1.0);
  const std::size_t place = place_after(tf.points, value);
  insert_at(tf, place, {point_at(value, curve), upper});
  return place + 1;
}

std::size_t make_step(TransferFunction& tf, std::size_t point) {
  ControlPoint lower = tf.points[point];
  lower.surface = {};
  lower.unknown.clear();
  lower.opacity = point > 0 ? tf.points[point - 1].opacity : 0;
  insert_at(tf, point, {lower});
  return point + 1;
}

void erase_points(TransferFunction& tf, const Selection& selection) {
  std::size_t i = 0;
  std::erase_if(tf.points, [&](const ControlPoint&) { return is_selected(selection, i++); });
}

std::span<const glm::dvec3> peak_colors() {
  static constexpr glm::dvec3 colors[] = {{0.90, 0.62, 0.00}, {0.34, 0.71, 0.91}, {0.80, 0.47, 0.65},
                                          {0.00, 0.62, 0.45}, {0.94, 0.89, 0.26}, {0.00, 0.45, 0.70},
                                          {0.84, 0.37, 0.00}};
  return colors;
}

glm::dvec3 peak_color(std::size_t n) { return peak_colors()[n % peak_colors().size()]; }

ValueRange range_in_domain(const TransferFunction& tf, ValueRange volume_range) {
  return tf.domain == Domain::normalized ? ValueRange{0, 1} : volume_range;
}

TransferFunction fitted(const TransferFunction& tf, ValueRange volume_range) {
  if (tf.points.empty() || !(tf.range().width() > 0)) return tf;
  return remap_values(tf, tf.range(), range_in_domain(tf, with_width(volume_range)));
}

TransferFunction in_domain(const TransferFunction& tf, Domain domain, ValueRange volume_range) {
  if (tf.domain == domain) return tf;
  const ValueRange data = with_width(volume_range), unit{0, 1};
  TransferFunction result =
      domain == Domain::data ? remap_values(tf, unit, data) : remap_values(tf, data, unit);
  result.domain = domain;
  return result;
}

}  // namespace crest
