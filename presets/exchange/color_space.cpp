// Colours between two, in the spaces that ParaView's maps name.
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <numbers>

#include "presets/exchange/curves.h"

namespace crest {
namespace {

using glm::dvec3;

constexpr dvec3 white{0.9505, 1, 1.089};  // D65, as vtkMath has it

dvec3 to_linear(const dvec3& rgb) {
  const auto one = [](double c) { return c > 0.04045 ? std::pow((c + 0.055) / 1.055, 2.4) : c / 12.92; };
  return {one(rgb.r), one(rgb.g), one(rgb.b)};
}
dvec3 to_display(const dvec3& rgb) {
  const auto one = [](double c) { return c > 0.0031308 ? 1.055 * std::pow(c, 1 / 2.4) - 0.055 : 12.92 * c; };
  return {one(rgb.r), one(rgb.g), one(rgb.b)};
}

dvec3 lab_of(const dvec3& rgb) {
  const dvec3 c = to_linear(rgb);
  const dvec3 xyz{0.4124 * c.r + 0.3576 * c.g + 0.1805 * c.b, 0.2126 * c.r + 0.7152 * c.g + 0.0722 * c.b,
                  0.0193 * c.r + 0.1192 * c.g + 0.9505 * c.b};
  const auto f = [](double t) { return t > 0.008856 ? std::cbrt(t) : 7.787 * t + 16.0 / 116; };
  const dvec3 v{f(xyz.x / white.x), f(xyz.y / white.y), f(xyz.z / white.z)};
  return {116 * v.y - 16, 500 * (v.x - v.y), 200 * (v.y - v.z)};
}

dvec3 rgb_of(const dvec3& lab) {
  const double y = (lab.x + 16) / 116, x = lab.y / 500 + y, z = y - lab.z / 200;
  const auto f = [](double t) { return t * t * t > 0.008856 ? t * t * t : (t - 16.0 / 116) / 7.787; };
  const dvec3 xyz = dvec3(f(x), f(y), f(z)) * white;
  dvec3 rgb = to_display({3.2406 * xyz.x - 1.5372 * xyz.y - 0.4986 * xyz.z,
                          -0.9689 * xyz.x + 1.8758 * xyz.y + 0.0415 * xyz.z,
                          0.0557 * xyz.x - 0.2040 * xyz.y + 1.0570 * xyz.z});
  const double most = std::max({rgb.r, rgb.g, rgb.b});
  if (most > 1) rgb /= most;
  return glm::max(rgb, 0.0);
}

/// Magnitude, saturation, hue.
dvec3 msh_of(const dvec3& rgb) {
  const dvec3 lab = lab_of(rgb);
  const double m = glm::length(lab), s = m > 0.001 ? std::acos(std::clamp(lab.x / m, -1.0, 1.0)) : 0;
  return {m, s, s > 0.001 ? std::atan2(lab.z, lab.y) : 0};
}
dvec3 rgb_of_msh(const dvec3& msh) {
  return rgb_of({msh.x * std::cos(msh.y), msh.x * std::sin(msh.y) * std::cos(msh.z),
                 msh.x * std::sin(msh.y) * std::sin(msh.z)});
}

double angle_between(double a, double b) {
  const double off = std::fmod(std::abs(a - b), 2 * std::numbers::pi);
  return std::min(off, 2 * std::numbers::pi - off);
}

/// The hue of a colour without saturation, from which the other one is reached best.
double adjusted_hue(const dvec3& saturated, double unsaturated_m) {
  if (saturated.x >= unsaturated_m - 0.1) return saturated.z;
  const double spin = saturated.y * std::sqrt(unsaturated_m * unsaturated_m - saturated.x * saturated.x) /
                      (saturated.x * std::sin(saturated.y));
  return saturated.z > -0.3 * std::numbers::pi ? saturated.z + spin : saturated.z - spin;
}

dvec3 diverging(const dvec3& a, const dvec3& b, double s) {
  dvec3 from = msh_of(a), to = msh_of(b);
  if (from.y > 0.05 && to.y > 0.05 && angle_between(from.z, to.z) > 0.33 * std::numbers::pi) {
    // Both are colours: white lies between them
    const dvec3 middle{std::max({from.x, to.x, 88.0}), 0, 0};
    (s < 0.5 ? to : from) = middle;
    s = s < 0.5 ? 2 * s : 2 * s - 1;
  }
  if (from.y < 0.05 && to.y > 0.05)
    from.z = adjusted_hue(to, from.x);
  else if (to.y < 0.05 && from.y > 0.05)
    to.z = adjusted_hue(from, to.x);
  return rgb_of_msh(glm::mix(from, to, s));
}

dvec3 hsv_of(const dvec3& rgb) {
  const double most = std::max({rgb.r, rgb.g, rgb.b}), least = std::min({rgb.r, rgb.g, rgb.b}),
               range = most - least;
  if (range <= 0) return {0, 0, most};
  const double hue = most == rgb.r   ? (rgb.g - rgb.b) / range
                     : most == rgb.g ? 2 + (rgb.b - rgb.r) / range
                                     : 4 + (rgb.r - rgb.g) / range;
  return {hue / 6 - std::floor(hue / 6), range / most, most};
}
dvec3 rgb_of_hsv(const dvec3& hsv) {
  const auto channel = [&](double n) {
    const double k = std::fmod(n + hsv.x * 6, 6.0);
    return hsv.z * (1 - hsv.y * std::clamp(std::min(k, 4 - k), 0.0, 1.0));
  };
  return {channel(5), channel(3), channel(1)};
}

dvec3 by_hue(const dvec3& a, const dvec3& b, double s) {
  dvec3 from = hsv_of(a), to = hsv_of(b);
  if (std::abs(from.x - to.x) > 0.5) (from.x > to.x ? from : to).x -= 1;
  dvec3 hsv = glm::mix(from, to, s);
  if (hsv.x < 0) hsv.x += 1;
  return rgb_of_hsv(hsv);
}

}  // namespace

dvec3 interpolate(const dvec3& a, const dvec3& b, double s, ColorSpace space) {
  switch (space) {
    case ColorSpace::rgb:
      return glm::mix(a, b, s);
    case ColorSpace::hsv:
      return by_hue(a, b, s);
    case ColorSpace::lab:
      return rgb_of(glm::mix(lab_of(a), lab_of(b), s));
    case ColorSpace::diverging:
      return diverging(a, b, s);
    case ColorSpace::step:
      break;
  }
  return b;
}

}  // namespace crest
