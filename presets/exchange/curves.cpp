#include "presets/exchange/curves.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/common.hpp>

#include "presets/error.h"

namespace crest {
namespace {

/// Half of 1/255 for the colour, and for the opacity: a line between points is at most that far off.
constexpr double tolerance = 0.5 / 255;
constexpr int most_halvings = 12;
/// What a preset's file has room for.
constexpr std::size_t most_points = 100000;

void require_room(std::size_t points) {
  if (points > most_points)
    throw Error(fmt::format("more than {} points, which a preset does not hold", most_points));
}

ControlPoint point_at(double value, const glm::dvec3& color, double opacity) {
  return {.value = value, .color = color, .opacity = opacity, .surface = {}, .unknown = {}};
}

double farthest(const glm::dvec3& a, const glm::dvec3& b) {
  const glm::dvec3 off = glm::abs(a - b);
  return std::max({off.x, off.y, off.z});
}

/// Where the way from a node to the next has got at s in [0, 1]: the place that a straight line would have
/// there.
struct Shape {
  double midpoint, sharpness;

  bool is_step() const { return sharpness > 0.99; }
  bool is_straight() const { return sharpness < 0.01 && midpoint == 0.5; }
  double at(double s) const {
    const double m = std::clamp(midpoint, 1e-5, 1 - 1e-5);
    s = s < m ? 0.5 * s / m : 0.5 + 0.5 * (s - m) / (1 - m);
    if (is_step()) return s < 0.5 ? 0 : 1;
    if (sharpness < 0.01) return s;
    const double power = 1 + 10 * sharpness;
    s = s < 0.5 ? 0.5 * std::pow(2 * s, power) : 1 - 0.5 * std::pow(2 * (1 - s), power);
    const double ss = s * s, sss = ss * s;
    const double rise = 1 - sharpness;
    return std::clamp(-2 * sss + 3 * ss + rise * ((sss - 2 * ss + s) + (sss - ss)), 0.0, 1.0);
  }
};

/// Adds the points of a curve within (0, 1] so that lines between them follow it. `at` is a function of s.
template <class At, class Add>
void follow(const At& at, double from, double to, int halvings, const Add& add) {
  const glm::dvec3 begin = at(from), end = at(to);
  double off = 0;
  for (const double s : {0.25, 0.5, 0.75})
    off = std::max(off, farthest(at(std::lerp(from, to, s)), glm::mix(begin, end, s)));
  if (off <= tolerance || halvings == most_halvings) return add(to, end);
  const double middle = 0.5 * (from + to);
  follow(at, from, middle, halvings + 1, add);
  follow(at, middle, to, halvings + 1, add);
}

/// The function of such nodes as a TF, whose colours are `value_of` the nodes, blended by `blend`.
template <class Node, class ValueOf, class Blend>
TransferFunction curve(std::vector<Node> nodes, const ValueOf& value_of, const Blend& blend,
                       bool is_straight_space) {
  require_room(nodes.size());
  std::ranges::stable_sort(nodes, {}, &Node::x);
  TransferFunction tf;
  if (!nodes.empty()) tf.points.push_back(point_at(nodes[0].x, value_of(nodes[0]), 0));
  for (std::size_t i = 1; i < nodes.size(); ++i) {
    const Node &a = nodes[i - 1], &b = nodes[i];
    const Shape shape{a.midpoint, a.sharpness};
    const glm::dvec3 begin = value_of(a), end = value_of(b);
    const auto add = [&](double s, const glm::dvec3& value) {
      require_room(tf.points.size() + 1);
      tf.points.push_back(point_at(s == 1 ? b.x : std::lerp(a.x, b.x, s), value, 0));
    };
    if (a.x == b.x || (shape.is_straight() && is_straight_space)) {
      add(1, end);
    } else if (shape.is_step()) {
      add(shape.midpoint, begin);
      add(shape.midpoint, end);
      add(1, end);
    } else {
      const auto at = [&](double s) { return blend(begin, end, shape.at(s)); };
      const double bend = std::clamp(shape.midpoint, 1e-5, 1 - 1e-5);
      follow(at, 0, bend, 0, add);
      follow(at, bend, 1, 0, add);
    }
  }
  return tf;
}

/// In Step the whole way to a node has the node's colour.
TransferFunction stepped(std::vector<ColorNode> nodes) {
  require_room(nodes.size());
  std::ranges::stable_sort(nodes, {}, &ColorNode::x);
  TransferFunction tf;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    tf.points.push_back(point_at(nodes[i].x, nodes[i].color, 0));
    if (i + 1 < nodes.size()) tf.points.push_back(point_at(nodes[i].x, nodes[i + 1].color, 0));
  }
  return tf;
}

}  // namespace

TransferFunction straightened(std::vector<ColorNode> colors, std::vector<OpacityNode> opacities,
                              ColorSpace space) {
  const auto in_space = [space](const glm::dvec3& a, const glm::dvec3& b, double s) {
    return interpolate(a, b, s, space);
  };
  const auto straight = [](const glm::dvec3& a, const glm::dvec3& b, double s) { return glm::mix(a, b, s); };
  const TransferFunction of_colors = space == ColorSpace::step
                                         ? stepped(std::move(colors))
                                         : curve(
                                               std::move(colors), [](const ColorNode& n) { return n.color; },
                                               in_space, space == ColorSpace::rgb);
  TransferFunction of_opacities = curve(
      std::move(opacities), [](const OpacityNode& n) { return glm::dvec3(n.opacity); }, straight, true);
  for (ControlPoint& point : of_opacities.points) point.opacity = point.color.r;
  return merged(of_colors, of_opacities);
}

TransferFunction merged(const TransferFunction& colors, const TransferFunction& opacities) {
  std::vector<double> values;
  for (const TransferFunction* tf : {&colors, &opacities})
    for (const ControlPoint& point : tf->points) values.push_back(point.value);
  std::ranges::sort(values);
  values.erase(std::unique(values.begin(), values.end()), values.end());
  TransferFunction tf = opacities;
  tf.points.clear();
  const auto color_at = [&](const Classified& c) { return colors.points.empty() ? glm::dvec3(1) : c.color; };
  for (const double value : values) {
    const glm::dvec3 left = color_at(evaluate_left(colors, value)),
                     right = color_at(evaluate_right(colors, value));
    // The points of opacity at this value, of which there may be any number; where there is none, the line's
    const auto& points = opacities.points;
    std::vector<ControlPoint> here(std::ranges::lower_bound(points, value, {}, &ControlPoint::value),
                                   std::ranges::upper_bound(points, value, {}, &ControlPoint::value));
    if (here.empty()) here.push_back(point_at(value, right, evaluate(opacities, value).opacity));
    if (here.size() == 1 && left != right) here.push_back(here.front());
    for (std::size_t i = 0; i < here.size(); ++i) here[i].color = i + 1 == here.size() ? right : left;
    tf.points.insert(tf.points.end(), here.begin(), here.end());
  }
  return tf;
}

TransferFunction simplified(const TransferFunction& tf, double off) {
  TransferFunction result = tf;
  result.points.clear();
  const auto& points = tf.points;
  const auto on_line = [&](std::size_t first, std::size_t last) {
    const ControlPoint &a = points[first], &b = points[last];
    for (std::size_t i = first + 1; i < last; ++i) {
      if (!(b.value > a.value)) return false;
      const double s = (points[i].value - a.value) / (b.value - a.value);
      if (std::abs(std::lerp(a.opacity, b.opacity, s) - points[i].opacity) > off ||
          farthest(glm::mix(a.color, b.color, s), points[i].color) > off)
        return false;
    }
    return true;
  };
  // From a kept point as far as a line holds, by doubling and then halving the way
  for (std::size_t at = 0; at < points.size();) {
    result.points.push_back(points[at]);
    if (at + 1 == points.size()) break;
    std::size_t good = at + 1, step = 1;
    while (good + step < points.size() && on_line(at, good + step)) {
      good += step;
      step *= 2;
    }
    for (; step > 0; step /= 2)
      if (good + step < points.size() && on_line(at, good + step)) good += step;
    at = good;
  }
  return result;
}

}  // namespace crest
