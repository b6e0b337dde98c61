#include "ui/move_points.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "presets/number_text.h"
#include "ui/curve_beneath.h"

namespace crest {
namespace {

using Points = std::vector<ControlPoint>;

constexpr double infinity = std::numeric_limits<double>::infinity();

/// For each point the values of the nearest points beside it that do not move.
std::vector<ValueRange> rooms_of(const Points& points, const Selection& moving) {
  std::vector<ValueRange> rooms(points.size(), {-infinity, infinity});
  double nearest = -infinity;
  for (std::size_t i = 0; i < points.size(); ++i) {
    rooms[i].min = nearest;
    if (!is_selected(moving, i)) nearest = points[i].value;
  }
  nearest = infinity;
  for (std::size_t i = points.size(); i-- > 0;) {
    rooms[i].max = nearest;
    if (!is_selected(moving, i)) nearest = points[i].value;
  }
  return rooms;
}

/// Shifts the points of `moving`. Values of few digits stay so: 29.9 becomes 39.9, not 39.899999999999999.
void shift_points(Points& points, const Selection& moving, double from, double to) {
  double scale = std::max(std::abs(from), std::abs(to));
  for (const std::size_t i : moving) scale = std::max(scale, std::abs(points[i].value));
  const bool tidy = std::ranges::all_of(
      moving, [&](std::size_t i) { return points[i].value == without_noise(points[i].value, scale); });
  for (const std::size_t i : moving) {
    double& value = points[i].value;
    if (value == from)
      value = to;
    else
      value = tidy ? without_noise(to + (value - from), scale) : to + (value - from);
  }
}

/// Whether a point goes with the one before it when it is pushed: within a spike, or at the same value.
std::vector<bool> joined_points(const TransferFunction& tf, const Selection& moving) {
  std::vector<bool> joined(tf.points.size());
  for (std::size_t i = 1; i < tf.points.size(); ++i) joined[i] = tf.points[i].value == tf.points[i - 1].value;
  for (const Peak& peak : find_peaks(tf))
    if (peak.spike) {
      const PointRange shape = points_of(tf, peak);
      std::fill_n(joined.begin() + std::ptrdiff_t(shape.first) + 1, shape.last - shape.first, true);
    }
  for (std::size_t i = 0; i < joined.size(); ++i)
    if (is_selected(moving, i) || (i > 0 && is_selected(moving, i - 1))) joined[i] = false;
  return joined;
}

/// Pushes what does not move ahead of what has moved up (direction 1) or down (-1).
void push_neighbours(Points& points, const TransferFunction& before, const Selection& moving,
                     double direction) {
  const std::vector<bool> joined = joined_points(before, moving);
  const std::size_t count = points.size();
  const auto place = [&](std::size_t k) { return direction > 0 ? k : count - 1 - k; };  // on the way
  const auto goes_on = [&](std::size_t k) {
    return k < count && joined[direction > 0 ? place(k) : place(k) + 1];
  };
  double front = -infinity;  // of the push, in the direction's values
  for (std::size_t k = 0; k < count;) {
    std::size_t end = k + 1;
    while (goes_on(end)) ++end;
    const double first = direction * points[place(k)].value;
    if (!is_selected(moving, place(k)) && first < front)
      for (std::size_t j = k; j < end; ++j) points[place(j)].value += direction * (front - first);
    if (is_selected(moving, place(k)) || front > -infinity)
      front = std::max(front, direction * points[place(end - 1)].value);
    k = end;
  }
}

}  // namespace

Moved in_order(const Points& points) {
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return points[i].value; });
  Moved result{{}, std::vector<std::size_t>(points.size())};
  for (const std::size_t i : order) {
    result.now_at[i] = result.points.size();
    result.points.push_back(points[i]);
  }
  return result;
}

PointRange points_of(const TransferFunction& tf, const Peak& peak) {
  const auto& points = tf.points;
  PointRange range{peak.left, peak.right};
  if (!peak.detected) return range;
  const double apex = std::midpoint(points[peak.first_point].value, points[peak.last_point].value);
  const auto is_alike = [&](std::size_t low, std::size_t high) {
    const double left = apex - points[low].value, right = points[high].value - apex;
    return std::abs(left - right) <= 1e-9 * (std::abs(apex) + left);
  };
  while (range.first > 0 && range.last + 1 < points.size() && is_alike(range.first, range.last) &&
         is_alike(range.first - 1, range.last + 1) &&
         points[range.first - 1].opacity < points[range.first].opacity &&
         points[range.last + 1].opacity < points[range.last].opacity) {
    --range.first;
    ++range.last;
  }
  return range;
}

Selection whole_of(const TransferFunction& tf, const Selection& selection, double reach) {
  const auto& points = tf.points;
  Selection all = selection;
  for (const Peak& peak : find_peaks(tf)) {
    const bool is_selected = std::ranges::any_of(
        selection, [&](std::size_t i) { return i >= peak.first_point && i <= peak.last_point; });
    const double apex = points[peak.first_point].value;
    const bool is_near = apex - points[peak.left].value < reach || points[peak.right].value - apex < reach;
    if (!peak.detected || !is_selected || !is_near) continue;
    const PointRange shape = points_of(tf, peak);
    for (std::size_t i = shape.first; i <= shape.last; ++i) all.push_back(i);
  }
  for (const std::size_t i : selection) {
    const auto at_value = std::ranges::equal_range(points, points[i].value, {}, &ControlPoint::value);
    if (at_value.size() != 2) continue;  // three are a spike: its top takes them along, a foot goes alone
    const auto first = std::size_t(at_value.begin() - points.begin());
    all.insert(all.end(), {first, first + 1});
  }
  std::ranges::sort(all);
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

Selection Moved::of(const Selection& before) const {
  Selection selection;
  for (const std::size_t i : before) selection.push_back(now_at[i]);
  std::ranges::sort(selection);
  return selection;
}

ValueRange room_of(const std::vector<ControlPoint>& points, const Selection& moving, std::size_t anchor) {
  const std::vector<ValueRange> rooms = rooms_of(points, moving);
  ValueRange room{-infinity, infinity};
  for (const std::size_t i : moving) {
    const double offset = points[anchor].value - points[i].value;
    room.min = std::max(room.min, rooms[i].min + offset);
    room.max = std::min(room.max, rooms[i].max + offset);
  }
  return room;
}

Moved moved(const TransferFunction& before, const Selection& moving, std::size_t anchor, double to,
            Neighbours neighbours) {
  Points points = before.points;
  if (moving.empty()) return in_order(points);
  const double from = points[anchor].value;
  if (neighbours == Neighbours::stop) {
    const ValueRange room = room_of(points, moving, anchor);
    to = std::clamp(to, room.min, room.max);
  }
  shift_points(points, moving, from, to);
  if (neighbours == Neighbours::stop) {  // rounding must not carry one past its neighbour
    const std::vector<ValueRange> rooms = rooms_of(before.points, moving);
    for (const std::size_t i : moving)
      points[i].value = std::clamp(points[i].value, rooms[i].min, rooms[i].max);
  }
  if (neighbours == Neighbours::push && to != from)
    push_neighbours(points, before, moving, to > from ? 1 : -1);
  stand_on_curve(points, before, moving);
  return in_order(points);
}

FieldRule value_rule(const std::vector<ControlPoint>& points, const Selection& moving, std::size_t anchor,
                     Neighbours neighbours) {
  FieldRule rule = any_value;
  if (neighbours != Neighbours::stop) return rule;
  const ValueRange room = room_of(points, moving, anchor);
  rule.min = std::max(rule.min, room.min);
  rule.max = std::min(rule.max, room.max);
  return rule;
}

void set_peak_width(TransferFunction& tf, const Peak& peak, double width) {
  if (!(width >= 0) || peak.right >= tf.points.size() || peak.left >= peak.first_point ||
      peak.right <= peak.last_point)
    return;
  const TransferFunction before = tf;
  const auto [left, right] = points_of(tf, peak);
  auto& points = tf.points;
  const double low = left > 0 ? points[left - 1].value : -infinity;
  const double high = right + 1 < points.size() ? points[right + 1].value : infinity;
  const double first = points[peak.first_point].value, last = points[peak.last_point].value;
  const double apex = (first + last) / 2;
  const double old_width = points[right].value - points[left].value;
  // A spike of no width has no proportions: its flanks go half the width to each side.
  const auto place = [&](double value, double side) {
    const double offset = old_width > 0 ? (value - apex) / old_width * width : side * width / 2;
    const double scale = std::max(std::abs(apex), std::abs(apex + offset));
    return std::clamp(without_noise(apex + offset, scale), low, high);
  };
  for (std::size_t i = left; i < peak.first_point; ++i)
    points[i].value = std::min(place(points[i].value, -1), first);
  for (std::size_t i = peak.last_point + 1; i <= right; ++i)
    points[i].value = std::max(place(points[i].value, 1), last);
  if (peak.first_point != peak.last_point)
    for (std::size_t i = peak.first_point; i <= peak.last_point; ++i)
      points[i].value = place(points[i].value, 0);
  Selection moving(right - left + 1);
  std::iota(moving.begin(), moving.end(), left);
  stand_on_curve(points, before, moving);
}

double peak_width(const TransferFunction& tf, const Peak& peak) {
  const PointRange shape = points_of(tf, peak);
  const double low = tf.points[shape.first].value, high = tf.points[shape.last].value;
  return without_noise(high - low, std::max(std::abs(low), std::abs(high)));
}

}  // namespace crest
