#include "ui/arrange_points.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "presets/number_text.h"

namespace crest {
namespace {

double aligned(std::vector<double> values, Alignment alignment) {
  if (alignment == Alignment::least) return *std::ranges::min_element(values);
  if (alignment == Alignment::greatest) return *std::ranges::max_element(values);
  const double sum = std::accumulate(values.begin(), values.end(), 0.0);
  return without_noise(sum / double(values.size()), std::abs(*std::ranges::max_element(values)));
}

std::vector<double> selected(const TransferFunction& tf, const Selection& selection,
                             double ControlPoint::*field) {
  std::vector<double> values;
  for (const std::size_t i : selection) values.push_back(tf.points[i].*field);
  return values;
}

double scale_of(ValueRange range) { return std::max(std::abs(range.min), std::abs(range.max)); }

}  // namespace

Moved stretched(const TransferFunction& before, const Selection& selection, ValueRange from, ValueRange to) {
  TransferFunction after = before;
  const double scale = std::max(scale_of(from), scale_of(to));
  for (const std::size_t i : selection) {
    double& value = after.points[i].value;
    const double at = from.width() > 0 ? std::lerp(to.min, to.max, (value - from.min) / from.width())
                                       : to.min + (value - from.min);
    value = value == from.min ? to.min : value == from.max ? to.max : without_noise(at, scale);
  }
  return in_order(after.points);
}

Moved mirrored(const TransferFunction& before, const Selection& selection) {
  const ValueRange range = values_of(before, selection);
  // Turned round, also among those that share a value: the order of the selected is the other way round.
  std::vector<ControlPoint> turned;
  for (const std::size_t i : selection) turned.push_back(before.points[i]);
  std::ranges::reverse(turned);
  TransferFunction after = before;
  for (std::size_t k = 0; k < selection.size(); ++k) {
    ControlPoint& point = after.points[selection[k]] = turned[k];
    point.value = point.value == range.min ? range.max
                  : point.value == range.max
                      ? range.min
                      : without_noise(range.min + (range.max - point.value), scale_of(range));
  }
  return in_order(after.points);
}

Moved with_values_aligned(const TransferFunction& before, const Selection& selection, Alignment alignment) {
  TransferFunction after = before;
  if (!selection.empty()) {
    const double value = aligned(selected(before, selection, &ControlPoint::value), alignment);
    for (const std::size_t i : selection) after.points[i].value = value;
  }
  return in_order(after.points);
}

void align_opacities(TransferFunction& tf, const Selection& selection, Alignment alignment) {
  if (selection.empty()) return;
  const double opacity = aligned(selected(tf, selection, &ControlPoint::opacity), alignment);
  for (const std::size_t i : selection) tf.points[i].opacity = std::clamp(opacity, 0.0, 1.0);
}

Moved with_values_distributed(const TransferFunction& before, const Selection& selection) {
  TransferFunction after = before;
  const ValueRange range = values_of(before, selection);
  for (std::size_t k = 1; k + 1 < selection.size(); ++k)
    after.points[selection[k]].value = without_noise(
        std::lerp(range.min, range.max, double(k) / double(selection.size() - 1)), scale_of(range));
  return in_order(after.points);
}

void interpolate_opacities(TransferFunction& tf, const Selection& selection) {
  if (selection.size() < 3) return;
  const ControlPoint first = tf.points[selection.front()], last = tf.points[selection.back()];
  const double width = last.value - first.value;
  for (std::size_t k = 1; k + 1 < selection.size(); ++k) {
    ControlPoint& point = tf.points[selection[k]];
    const double t =
        width > 0 ? (point.value - first.value) / width : double(k) / double(selection.size() - 1);
    point.opacity = std::clamp(without_noise(std::lerp(first.opacity, last.opacity, t), 1), 0.0, 1.0);
  }
}

void scale_opacities(TransferFunction& tf, const Selection& selection, double factor) {
  const auto scaled = [&](double opacity) {
    return std::clamp(without_noise(opacity * factor, opacity * factor), 0.0, 1.0);
  };
  for (const std::size_t i : selection) {
    ControlPoint& point = tf.points[i];
    point.opacity = scaled(point.opacity);
    if (point.surface.opacity) point.surface.opacity = scaled(*point.surface.opacity);
  }
}

Selection everything(const TransferFunction& tf) {
  Selection all(tf.points.size());
  std::iota(all.begin(), all.end(), std::size_t(0));
  return all;
}

Selection selected_or_all(const TransferFunction& tf, const Selection& selection) {
  return selection.size() > 1 ? selection : everything(tf);
}

ValueRange values_of(const TransferFunction& tf, const Selection& selection) {
  if (selection.empty()) return {0, 0};
  return {tf.points[selection.front()].value, tf.points[selection.back()].value};
}

}  // namespace crest
