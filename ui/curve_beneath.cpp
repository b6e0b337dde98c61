#include "ui/curve_beneath.h"

#include <algorithm>
#include <cmath>

#include "ui/move_points.h"

namespace crest {
namespace {

using Points = std::vector<ControlPoint>;

bool all_selected(const Selection& selection, std::size_t first, std::size_t last) {
  for (std::size_t i = first; i <= last; ++i)
    if (!is_selected(selection, i)) return false;
  return true;
}

bool is_same(const glm::dvec3& a, const glm::dvec3& b) {
  return std::abs(a.r - b.r) + std::abs(a.g - b.g) + std::abs(a.b - b.b) < 1e-9;
}

TransferFunction without(const TransferFunction& tf, const Points& points, const Selection& selection) {
  TransferFunction rest = tf;
  rest.points = points;
  erase_points(rest, selection);
  return rest;
}

/// Whether a point has the opacity of a curve at its value, on either side.
bool is_on(const TransferFunction& curve, const ControlPoint& point) {
  for (const Classified& on : {evaluate_left(curve, point.value), evaluate_right(curve, point.value)})
    if (std::abs(on.opacity - point.opacity) <= 1e-9) return true;
  return false;
}

/// The steps that move and begin or end on the curve that there is without them.
std::vector<PointRange> standing_steps(const TransferFunction& tf, const Selection& moving) {
  std::vector<PointRange> standing;
  for (std::size_t i = 0; i + 1 < tf.points.size(); ++i) {
    const auto same = std::ranges::equal_range(tf.points, tf.points[i].value, {}, &ControlPoint::value);
    if (same.size() != 2 || tf.points[i + 1].value != tf.points[i].value) continue;
    if (!all_selected(moving, i, i + 1)) continue;
    const TransferFunction rest = without(tf, tf.points, {i, i + 1});
    if (!rest.points.empty() && (is_on(rest, tf.points[i]) || is_on(rest, tf.points[i + 1])))
      standing.push_back({i, i + 1});
  }
  return standing;
}

/// The shapes that stand on the curve beneath, or may: spikes, and peaks and steps that move as a whole.
std::vector<PointRange> standing_shapes(const TransferFunction& tf, const Selection& moving) {
  std::vector<PointRange> standing;
  for (const Peak& peak : find_peaks(tf)) {
    const PointRange shape = points_of(tf, peak);
    if (peak.detected && (peak.spike || all_selected(moving, shape.first, shape.last)))
      standing.push_back(shape);
  }
  std::ranges::copy(standing_steps(tf, moving), std::back_inserter(standing));
  std::ranges::sort(standing, {}, &PointRange::first);
  return standing;
}

/// The curve beneath before and after a move: all points but those of the peaks that stand on it.
struct CurveBeneath {
  TransferFunction before, after;

  /// What `point` has at its new place, if it stood on the curve.
  void stand(const ControlPoint& was, ControlPoint& point, const Classified& place) const {
    if (!is_on(before, was)) return;
    const ControlPoint on_curve = point_at(point.value, place);
    point.opacity = on_curve.opacity;
    if (is_same(evaluate_left(before, was.value).color, was.color) ||
        is_same(evaluate_right(before, was.value).color, was.color))
      point.color = on_curve.color;
  }
  /// Between foot and top a point keeps its share of the height.
  void keep_share(const ControlPoint& was, ControlPoint& point, double top) const {
    const double old_floor = evaluate(before, was.value).opacity,
                 floor = evaluate(after, point.value).opacity;
    if (was.opacity >= top || !(top > old_floor)) return;
    const double share = (was.opacity - old_floor) / (top - old_floor);
    point.opacity = point_at(point.value, {point.color, std::lerp(floor, top, share)}).opacity;
  }
};

}  // namespace

void stand_on_curve(Points& after, const TransferFunction& before, const Selection& moving) {
  const std::vector<PointRange> peaks = standing_shapes(before, moving);
  Selection shapes;
  for (const PointRange& peak : peaks)
    for (std::size_t i = std::max(peak.first, shapes.empty() ? 0 : shapes.back() + 1); i <= peak.last; ++i)
      shapes.push_back(i);
  CurveBeneath curve{without(before, before.points, shapes), without(before, after, shapes)};
  if (curve.before.points.empty()) return;
  std::ranges::stable_sort(curve.after.points, {}, &ControlPoint::value);
  const auto stands = [&](std::size_t foot) { return is_on(curve.before, before.points[foot]); };
  for (const PointRange& peak : peaks) {
    const auto place = [&](std::size_t i) { return after[i].value; };
    curve.stand(before.points[peak.first], after[peak.first], evaluate_right(curve.after, place(peak.first)));
    curve.stand(before.points[peak.last], after[peak.last], evaluate_left(curve.after, place(peak.last)));
    if (!stands(peak.first) || !stands(peak.last)) continue;
    double top = 0;
    for (std::size_t i = peak.first; i <= peak.last; ++i) top = std::max(top, before.points[i].opacity);
    for (std::size_t i = peak.first + 1; i < peak.last; ++i)
      curve.keep_share(before.points[i], after[i], top);
  }
}

void keep_feet_on_curve(TransferFunction& tf, const TransferFunction& before) {
  Points kept = tf.points;
  stand_on_curve(kept, before, {});
  for (std::size_t i = 0; i < kept.size(); ++i) {
    const bool is_edited =
        tf.points[i].opacity != before.points[i].opacity || tf.points[i].color != before.points[i].color;
    if (!is_edited) tf.points[i] = kept[i];
  }
}

}  // namespace crest
