#include "ui/shapes.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "presets/number_text.h"

namespace crest {
namespace {

constexpr double deviations = 7;  // of a Gaussian, from foot to foot

/// Of the place from -1/2 to 1/2; 0 at the feet, where it would be 0.002.
double gaussian(double place) {
  const double t = place * deviations;
  return std::abs(place) >= 0.5 ? 0 : std::exp(-t * t / 2);
}

/// How far the line from `a` to `b` is off the Gaussian.
double chord_error(double a, double b) {
  constexpr int samples = 32;
  double most = 0;
  for (int i = 1; i < samples; ++i) {
    const double t = double(i) / samples;
    most = std::max(most, std::abs(std::lerp(gaussian(a), gaussian(b), t) - gaussian(std::lerp(a, b, t))));
  }
  return most;
}

/// The longest chord from `a` that keeps the error, by bisection: the error grows with its length but for
/// the Gaussian's one inflection, which a chord may pass.
double chord_end(double a) {
  if (chord_error(a, 0.5) <= gaussian_error) return 0.5;
  double good = a, bad = 0.5;
  for (int i = 0; i < 40; ++i) {
    const double middle = (good + bad) / 2;
    (chord_error(a, middle) <= gaussian_error ? good : bad) = middle;
  }
  return good;
}

std::vector<ShapeCorner> gaussian_corners() {
  std::vector<ShapeCorner> right;
  for (double place = 0; place < 0.5;) {
    place = std::round(chord_end(place) * 1000) / 1000;  // numbers that a person can read
    right.push_back({place, gaussian(place)});
  }
  std::vector<ShapeCorner> corners;
  for (std::size_t i = right.size(); i-- > 0;) corners.push_back({-right[i].place, right[i].height});
  corners.push_back({0, 1});
  corners.insert(corners.end(), right.begin(), right.end());
  return corners;
}

double opacity_at(OpacityShape shape, double place) {
  switch (shape) {
    case OpacityShape::ramp_up:
      return place + 0.5;
    case OpacityShape::ramp_down:
      return 0.5 - place;
    case OpacityShape::tent:
      return 1 - 2 * std::abs(place);
    case OpacityShape::gaussian:
      return gaussian(place);
    default:
      return 1;
  }
}

}  // namespace

std::span<const ShapeCorner> corners_of(Shape shape) {
  static constexpr std::array<ShapeCorner, 3> tent{{{-0.5, 0}, {0, 1}, {0.5, 0}}};
  static constexpr std::array<ShapeCorner, 4> box{{{-0.5, 0}, {-0.5, 1}, {0.5, 1}, {0.5, 0}}};
  static constexpr std::array<ShapeCorner, 2> ramp{{{-0.5, 0}, {0.5, 1}}}, step{{{0, 0}, {0, 1}}};
  static const std::vector<ShapeCorner> bell = gaussian_corners();
  switch (shape) {
    case Shape::box:
      return box;
    case Shape::gaussian:
      return bell;
    case Shape::ramp:
      return ramp;
    case Shape::step:
      return step;
    default:
      return tent;
  }
}

Selection insert_shape(TransferFunction& tf, Shape shape, double value, double opacity, double width,
                       glm::dvec3 color) {
  if (shape == Shape::spike) return {insert_peak(tf, value, opacity, width, color)};
  if (shape == Shape::step) return {insert_step(tf, value, opacity)};
  const TransferFunction curve = tf;
  const double low = value - width / 2, high = value + width / 2;
  std::erase_if(tf.points, [&](const ControlPoint& p) { return p.value > low && p.value < high; });
  const auto place = std::ranges::find_if(tf.points, [&](const ControlPoint& p) { return p.value >= high; });
  const auto first = std::size_t(place - tf.points.begin());
  std::vector<ControlPoint> points;
  for (const ShapeCorner& corner : corners_of(shape)) {
    const double scale = std::max(std::abs(low), std::abs(high));
    const double at = without_noise(value + corner.place * width, scale);
    const Classified beneath = at < value ? evaluate_right(curve, at) : evaluate_left(curve, at);
    points.push_back(point_at(
        at, {corner.height > 0 ? color : beneath.color, std::lerp(beneath.opacity, opacity, corner.height)}));
  }
  tf.points.insert(tf.points.begin() + std::ptrdiff_t(first), points.begin(), points.end());
  if (shape == Shape::tent) return {first + 1};
  Selection all;
  for (std::size_t i = 0; i < points.size(); ++i) all.push_back(first + i);
  return all;
}

TransferFunction with_opacities(const TransferFunction& tf, OpacityShape shape, double opacity) {
  if (tf.points.empty()) return tf;
  TransferFunction result = tf;
  const ValueRange range = tf.range();
  const double middle = (range.min + range.max) / 2;
  const auto add_corners = [&](Shape like) {
    for (const ShapeCorner& corner : corners_of(like)) {
      const double value = middle + corner.place * range.width();
      if (std::ranges::find(result.points, value, &ControlPoint::value) == result.points.end())
        insert_point(result, value, 0);
    }
  };
  if (shape == OpacityShape::tent) add_corners(Shape::tent);
  if (shape == OpacityShape::gaussian) add_corners(Shape::gaussian);
  for (ControlPoint& point : result.points) {
    const double place = range.width() > 0 ? (point.value - middle) / range.width() : 0;
    point.opacity = without_noise(opacity * std::clamp(opacity_at(shape, place), 0.0, 1.0), 1);
  }
  return result;
}

std::string_view label_of(Shape shape) {
  constexpr std::string_view labels[] = {"Spike", "Tent", "Box", "Gaussian", "Ramp", "Step"};
  return labels[std::size_t(shape)];
}

std::string_view label_of(OpacityShape shape) {
  constexpr std::string_view labels[] = {"Flat", "Rising", "Falling", "Tent over all", "Gaussian over all"};
  return labels[std::size_t(shape)];
}

}  // namespace crest
