#include "render/studies/placement/square.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/trigonometric.hpp>
#include <numbers>

namespace crest {
namespace {

constexpr double half = Square::side / 2, fan_degrees = 30;
constexpr glm::dvec2 eye(-9, 0);

/// From the world into the square's own frame.
glm::dvec2 turned_back(glm::dvec2 v) {
  const double c = std::cos(Square::angle), s = std::sin(Square::angle);
  return {c * v.x + s * v.y, c * v.y - s * v.x};
}

}  // namespace

double Square::value(glm::dvec2 position) const {
  const glm::dvec2 p = glm::clamp((position + half) / spacing, 0.0, double(points - 1));
  const glm::ivec2 cell = glm::min(glm::ivec2(p), points - 2);
  const glm::dvec2 w = p - glm::dvec2(cell);
  const auto at = [&](int i, int j) { return values[std::size_t((cell.y + j) * points + cell.x + i)]; };
  return glm::mix(glm::mix(at(0, 0), at(1, 0), w.x), glm::mix(at(0, 1), at(1, 1), w.x), w.y);
}

Square make_square(const std::function<double(glm::dvec2)>& formula) {
  Square square;
  for (int j = 0; j < Square::points; ++j)
    for (int i = 0; i < Square::points; ++i)
      square.values[std::size_t(j * Square::points + i)] = formula(Square::spacing * glm::dvec2(i, j) - half);
  return square;
}

Square linear_square() {
  return make_square([](glm::dvec2 p) { return (p.x + half) / Square::side; });
}

Square curved_square() {
  constexpr double k = std::numbers::pi / half;
  return make_square([](glm::dvec2 p) { return (1 + std::cos(k * p.x) * std::cos(k * p.y)) / 2; });
}

std::optional<PlaneRay> fan_ray(double angle) {
  PlaneRay ray{turned_back(eye), turned_back({std::cos(angle), std::sin(angle)}), 0, HUGE_VAL};
  for (int axis = 0; axis < 2; ++axis) {
    const double a = (-half - ray.origin[axis]) / ray.direction[axis],
                 b = (half - ray.origin[axis]) / ray.direction[axis];
    ray.enter = std::max(ray.enter, std::min(a, b));
    ray.exit = std::min(ray.exit, std::max(a, b));
  }
  if (ray.exit <= ray.enter) return std::nullopt;
  return ray;
}

double fan_angle_degrees(int ray, int rays) { return fan_degrees * (double(ray) / (rays - 1) - 0.5); }

std::vector<std::optional<PlaneRay>> fan(int rays) {
  std::vector<std::optional<PlaneRay>> result;
  for (int i = 0; i < rays; ++i) result.push_back(fan_ray(glm::radians(fan_angle_degrees(i, rays))));
  return result;
}

std::vector<double> pieces_of(const PlaneRay& ray) {
  std::vector<double> ends{ray.enter, ray.exit};
  for (int axis = 0; axis < 2; ++axis)
    for (int line = 1; line < Square::points - 1; ++line) {
      const double t = (line * Square::spacing - half - ray.origin[axis]) / ray.direction[axis];
      if (t > ray.enter && t < ray.exit) ends.push_back(t);
    }
  std::ranges::sort(ends);
  return ends;
}

double exact_intensity(const Square& square, const PlaneRay& ray) {
  const auto tau = [&](double t) { return square.value(ray.at(t)) / 2; };
  const std::vector<double> ends = pieces_of(ray);
  double depth = 0;
  for (std::size_t i = 1; i < ends.size(); ++i) {
    const double a = ends[i - 1], b = ends[i];
    depth += (b - a) / 6 * (tau(a) + 4 * tau((a + b) / 2) + tau(b));
  }
  return -2 * std::expm1(-depth);
}

}  // namespace crest
