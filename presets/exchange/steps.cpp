#include "presets/exchange/steps.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace crest {
namespace {

using Points = std::vector<ControlPoint>;

struct Group {
  std::size_t first, last;
};

/// Which point of a group stays.
std::size_t anchor_of(const Points& points, Group group) {
  std::size_t highest = group.last;
  for (std::size_t i = group.last; i-- > group.first;)
    if (points[i].opacity > points[highest].opacity) highest = i;
  const bool is_peak = points[highest].opacity > points[group.first].opacity &&
                       points[highest].opacity > points[group.last].opacity;
  return is_peak ? highest : group.last;
}

/// The distance to the neighbours of a step's value, shared among the points that are put there.
double room_beside(const Points& points, Group group) {
  double room = std::numeric_limits<double>::infinity();
  if (group.first > 0) room = points[group.first].value - points[group.first - 1].value;
  if (group.last + 1 < points.size())
    room = std::min(room, points[group.last + 1].value - points[group.last].value);
  return 0.5 * room / double(group.last - group.first);
}

}  // namespace

std::vector<double> separated_values(const TransferFunction& tf, Separation separation) {
  const Points& points = tf.points;
  const double least_size = separation.least_size * tf.range().width();
  const auto gap_at = [&](double value) {
    const double size = std::max({std::abs(value), least_size, double(std::numeric_limits<float>::min())});
    return separation.units * 0x1p-23 * size;
  };
  std::vector<double> values;
  for (const ControlPoint& point : points) values.push_back(point.value);

  for (std::size_t first = 0; first < points.size();) {
    Group group{first, first};
    const auto is_near = [&](std::size_t i) {
      const double apart = points[i + 1].value - points[i].value;
      return separation.steps_only ? apart == 0 : apart < gap_at(points[i + 1].value);
    };
    while (group.last + 1 < points.size() && is_near(group.last)) ++group.last;
    first = group.last + 1;
    if (group.first == group.last) continue;
    const std::size_t anchor = anchor_of(points, group);
    double gap = gap_at(points[anchor].value);
    if (separation.steps_only) gap = std::min(gap, room_beside(points, group));
    for (std::size_t i = anchor; i-- > group.first;) values[i] = std::min(values[i], values[i + 1] - gap);
    for (std::size_t i = anchor + 1; i <= group.last; ++i)
      values[i] = std::max(values[i], values[i - 1] + gap);
  }
  // Where groups were pushed into each other, or the room was less than a double has digits
  for (std::size_t i = 1; i < values.size(); ++i) {
    const double least = separation.steps_only
                             ? std::nextafter(values[i - 1], std::numeric_limits<double>::infinity())
                             : values[i - 1] + gap_at(values[i - 1]);
    values[i] = std::max(values[i], least);
  }
  return values;
}

double farthest_move(const TransferFunction& tf, const std::vector<double>& values) {
  double farthest = 0;
  for (std::size_t i = 0; i < values.size(); ++i)
    farthest = std::max(farthest, std::abs(values[i] - tf.points[i].value));
  return farthest;
}

}  // namespace crest
