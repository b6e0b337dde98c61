#pragma once

#include <array>
#include <functional>
#include <glm/vec2.hpp>
#include <optional>
#include <vector>

namespace crest {

/// The plane set-up of Steneteg et al., section V.A: a square about the origin, turned, that holds 5 x 5
/// points, bilinear between them, seen by a fan of rays.
struct Square {
  static constexpr double side = 3, angle = 3.14159265358979323846 / 7;
  static constexpr int points = 5;  ///< an axis
  static constexpr double spacing = side / (points - 1);

  std::array<double, points * points> values{};  ///< x fastest, from the corner (-1.5, -1.5)

  double value(glm::dvec2 position) const;  ///< in the square's own frame; constant beyond it
};

/// The points of a formula over [-1.5, 1.5]^2.
Square make_square(const std::function<double(glm::dvec2)>& formula);

/// The paper's field, (x + 1.5) / 3: its interpolant is the formula itself.
Square linear_square();
/// (1 + cos(pi x / 1.5) cos(pi y / 1.5)) / 2: curved, with much at the border, as a crystal's cell. The truth
/// is that of its interpolant, which has kinks where the ray passes from cell to cell.
Square curved_square();

/// A ray in the square's own frame; distances are from the eye.
struct PlaneRay {
  glm::dvec2 origin{0}, direction{1, 0};
  double enter = 0, exit = 0;
  glm::dvec2 at(double distance) const { return origin + distance * direction; }
};

/// The ray from the paper's eye at (-9, 0), so far up from the x-axis; nothing if it misses the square.
std::optional<PlaneRay> fan_ray(double angle_radians);

/// The paper's rays: at equal angles over 30 degrees, from below to above: nothing where
/// one misses the square. The paper has 120 rays.
inline constexpr int paper_rays = 120;
double fan_angle_degrees(int ray, int rays = paper_rays);
std::vector<std::optional<PlaneRay>> fan(int rays = paper_rays);

/// Where a ray enters, passes into another cell, and leaves: between these the field is quadratic.
std::vector<double> pieces_of(const PlaneRay& ray);

/// The paper's eq. (3), with g = s and tau = s/2. As g = 2 tau, it is the integral of 2 tau exp(-depth) over
/// the depth's own change: I = 2 (1 - exp(-depth)), where depth, the integral of tau, is that of a quadratic
/// in each cell and Simpson's rule is exact.
double exact_intensity(const Square& square, const PlaneRay& ray);

}  // namespace crest
