#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "ui/edit_points.h"

namespace crest::test {
namespace {

/// Rows, of linear RGB: Machado, Oliveira and Fernandes, "A Physiologically-based Model for Simulation of
/// Color Vision Deficiency", TVCG 15(6) 2009, at full severity.
struct Vision {
  const char* name;
  std::array<glm::dvec3, 3> rows;
};
constexpr Vision visions[] = {
    {"normal", {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}},
    {"protanopia",
     {{{0.152286, 1.052583, -0.204868}, {0.114503, 0.786281, 0.099216}, {-0.003882, -0.048116, 1.051998}}}},
    {"deuteranopia",
     {{{0.367322, 0.860646, -0.227968}, {0.280085, 0.672501, 0.047413}, {-0.011820, 0.042940, 0.968881}}}}};

double linear(double v) { return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4); }

double dot(glm::dvec3 a, glm::dvec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

glm::dvec3 seen_by(const Vision& vision, glm::dvec3 color) {
  const glm::dvec3 c(linear(color.r), linear(color.g), linear(color.b));
  const auto clamped = [](double v) { return std::min(std::max(v, 0.0), 1.0); };
  return {clamped(dot(vision.rows[0], c)), clamped(dot(vision.rows[1], c)), clamped(dot(vision.rows[2], c))};
}

/// CIE L*a*b* of linear sRGB, white point D65.
glm::dvec3 lab(glm::dvec3 c) {
  const glm::dvec3 xyz(dot({0.4124564, 0.3575761, 0.1804375}, c) / 0.95047,
                       dot({0.2126729, 0.7151522, 0.0721750}, c),
                       dot({0.0193339, 0.1191920, 0.9503041}, c) / 1.08883);
  const auto f = [](double t) { return t > 216.0 / 24389 ? std::cbrt(t) : (24389.0 / 27 * t + 16) / 116; };
  return {116 * f(xyz.y) - 16, 500 * (f(xyz.x) - f(xyz.y)), 200 * (f(xyz.y) - f(xyz.z))};
}

double difference(const Vision& vision, glm::dvec3 a, glm::dvec3 b) {
  const glm::dvec3 d = lab(seen_by(vision, a)) - lab(seen_by(vision, b));
  return std::sqrt(dot(d, d));
}

TEST(PeakColors, TheColourBlindTellThemApart) {
  for (const Vision& vision : visions)
    for (std::size_t i = 0; i < peak_colors().size(); ++i)
      for (std::size_t j = i + 1; j < peak_colors().size(); ++j)
        EXPECT_GT(difference(vision, peak_colors()[i], peak_colors()[j]), 15)
            << vision.name << ", " << i << " and " << j;
}

// That the test can fail: red and green of the same lightness.
TEST(PeakColors, RedAndGreenAreNotToldApart) {
  EXPECT_GT(difference(visions[0], {0.80, 0.30, 0.20}, {0.45, 0.50, 0.10}), 40);
  EXPECT_LT(difference(visions[2], {0.80, 0.30, 0.20}, {0.45, 0.50, 0.10}), 15);
}

TEST(PeakColors, NewPeaksTakeThemInTurn) {
  for (std::size_t i = 0; i < 2 * peak_colors().size(); ++i)
    EXPECT_EQ(peak_color(i), peak_colors()[i % peak_colors().size()]);
}

}  // namespace
}  // namespace crest::test
