#include "ui/edit_points.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ui/value_axis.h"

namespace crest {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

ControlPoint point_at(double value, const Classified& curve) {
  ControlPoint point;
  point.value = value;
  point.color = curve.color;
  point.opacity = std::clamp(curve.opacity, 0.0, 1.0);
  return point;
}

/// The first point above `value`.
std::size_t place_after(const std::vector<ControlPoint>& points, double value) {
  return std::size_t(std::upper_bound(points.begin(), points.end(), value,
                                      [](double v, const ControlPoint& p) { return v < p.value; }) -
                     points.begin());
}

void insert_at(TransferFunction& tf, std::size_t place, std::initializer_list<ControlPoint> points) {
  tf.points.insert(tf.points.begin() + std::ptrdiff_t(place), points);
}

bool contains(const Selection& selection, std::size_t i) {
  return std::binary_search(selection.begin(), selection.end(), i);
}

/// For each point the values of the nearest points beside it that are not selected.
std::vector<ValueRange> rooms_of(const std::vector<ControlPoint>& points, const Selection& selection) {
  std::vector<ValueRange> rooms(points.size(), {-infinity, infinity});
  double nearest = -infinity;
  for (std::size_t i = 0; i < points.size(); ++i) {
    rooms[i].min = nearest;
    if (!contains(selection, i)) nearest = points[i].value;
  }
  nearest = infinity;
  for (std::size_t i = points.size(); i-- > 0;) {
    rooms[i].max = nearest;
    if (!contains(selection, i)) nearest = points[i].value;
  }
  return rooms;
}

}  // namespace

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
  std::erase_if(tf.points, [&](const ControlPoint&) { return contains(selection, i++); });
}

ValueRange room_of(const std::vector<ControlPoint>& points, std::size_t point, const Selection& selection) {
  return rooms_of(points, selection)[point];
}

Selection with_near_flanks(const std::vector<ControlPoint>& points, const Selection& selection,
                           double reach) {
  TransferFunction tf;
  tf.points = points;
  Selection all = selection;
  for (const Peak& peak : find_peaks(tf)) {
    const bool is_selected = std::ranges::any_of(
        selection, [&](std::size_t i) { return i >= peak.first_point && i <= peak.last_point; });
    const double apex = points[peak.first_point].value;
    const bool is_near = apex - points[peak.left].value < reach || points[peak.right].value - apex < reach;
    if (!is_selected || !is_near) continue;
    for (std::size_t i = peak.left; i <= peak.right; ++i) all.push_back(i);
  }
  std::ranges::sort(all);
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

std::vector<ControlPoint> moved(const std::vector<ControlPoint>& before, const Selection& selection,
                                double shift, double resolution) {
  const std::vector<ValueRange> rooms = rooms_of(before, selection);
  double least = -infinity, most = infinity;
  for (const std::size_t i : selection) {
    least = std::max(least, rooms[i].min - before[i].value);
    most = std::min(most, rooms[i].max - before[i].value);
  }
  std::vector<ControlPoint> points = before;
  if (selection.empty()) return points;
  const double middle = before[selection[selection.size() / 2]].value;
  const double allowed = round_to_resolution(middle + std::clamp(shift, least, most), resolution) - middle;
  for (const std::size_t i : selection)
    points[i].value = std::clamp(before[i].value + allowed, rooms[i].min, rooms[i].max);
  return points;
}

void set_peak_width(TransferFunction& tf, const Peak& peak, double width) {
  auto& points = tf.points;
  if (!(width >= 0) || peak.right >= points.size() || peak.left >= peak.first_point ||
      peak.right <= peak.last_point)
    return;
  const double low = peak.left > 0 ? points[peak.left - 1].value : -infinity;
  const double high = peak.right + 1 < points.size() ? points[peak.right + 1].value : infinity;
  const double first = points[peak.first_point].value, last = points[peak.last_point].value;
  const double apex = (first + last) / 2;
  const double old_width = points[peak.right].value - points[peak.left].value;
  // A spike of no width has no proportions: its flanks go half the width to each side.
  const auto place = [&](double value, double side) {
    const double offset = old_width > 0 ? (value - apex) / old_width * width : side * width / 2;
    return apex + offset;
  };
  for (std::size_t i = peak.left; i < peak.first_point; ++i)
    points[i].value = std::clamp(place(points[i].value, -1), low, high);
  for (std::size_t i = peak.last_point + 1; i <= peak.right; ++i)
    points[i].value = std::clamp(place(points[i].value, 1), low, high);
  if (peak.first_point != peak.last_point)
    for (std::size_t i = peak.first_point; i <= peak.last_point; ++i)
      points[i].value = std::clamp(place(points[i].value, 0), low, high);
}

glm::dvec3 peak_color(std::size_t n) {
  constexpr double golden = 0.618033988749895;
  const double hue = std::fmod(0.06 + double(n) * golden, 1.0);
  const auto channel = [&](double offset) {
    const double k = std::fmod(offset + hue * 6, 6.0);
    return 0.98 - 0.68 * std::clamp(std::min(k, 4 - k), 0.0, 1.0);
  };
  const auto tidy = [](double v) { return std::round(v * 100) / 100; };
  return {tidy(channel(5)), tidy(channel(3)), tidy(channel(1))};
}

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
