#include "render/measure/flip.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "pictures.h"

namespace crest {
namespace {

using testing::filled;
using testing::random_squares;

double mean(const std::vector<float>& map) {
  double sum = 0;
  for (const float value : map) sum += value;
  return sum / double(map.size());
}

TEST(Flip, OfEqualPicturesIsNothing) {
  const Image image = random_squares({40, 30}, 7, 3);
  for (const float value : flip_map(image, image)) EXPECT_EQ(value, 0);
}

TEST(Flip, IsSymmetricAndWithinUnity) {
  const Image a = random_squares({40, 30}, 7, 3), b = random_squares({40, 30}, 3, 4);
  const auto ab = flip_map(a, b), ba = flip_map(b, a);
  for (std::size_t i = 0; i < ab.size(); ++i) {
    EXPECT_NEAR(ab[i], ba[i], 1e-6);
    EXPECT_TRUE(ab[i] >= 0 && ab[i] <= 1);
  }
  EXPECT_GT(mean(ab), 0.2);
}

// Uniform pictures have no features, and no filter changes them: the colour metric alone, by hand.
TEST(Flip, OfBlackAndWhiteByHand) {
  // L* differs by 100. The largest distance is that of green and blue, (87.74, -86.18, 83.18) and (32.30,
  // 79.19, -107.86) in L*a*b*, whose a* and b* are taken times L*/100.
  const double largest_distance =
      87.74 - 32.30 + std::hypot(0.8774 * 86.18 + 0.3230 * 79.19, 0.8774 * 83.18 + 0.3230 * 107.86);
  const double difference = std::pow(100, 0.7), largest = std::pow(largest_distance, 0.7);
  const double expected = 0.95 + 0.05 * (difference - 0.4 * largest) / (0.6 * largest);
  const auto map = flip_map(filled({30, 30}, glm::vec4(0, 0, 0, 1)), filled({30, 30}, glm::vec4(1)));
  for (const float value : map) EXPECT_NEAR(value, expected, 1e-4);
}

TEST(Flip, OfGreenAndBlueIsTheMost) {
  const auto map = flip_map(filled({30, 30}, glm::vec4(0, 1, 0, 1)), filled({30, 30}, glm::vec4(0, 0, 1, 1)));
  for (const float value : map) EXPECT_NEAR(value, 1, 1e-4);
}

TEST(Flip, FinePatternsAreNotSeenFromAfar) {
  const Image grey = filled({64, 64}, glm::vec4(0.735f, 0.735f, 0.735f, 1));  // half the light of white
  Image checkers = grey;
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) checkers.at(x, y) = glm::vec4(glm::vec3(float((x + y) % 2)), 1);
  EXPECT_LT(mean(flip_map(grey, checkers)), 0.25 * mean(flip_map(grey, checkers, 10)));
}

// The same from the paper's formulas, slowly: whole two-dimensional kernels, in double.
namespace slow {

using Plane = std::vector<double>;
constexpr double pi = std::numbers::pi;

Plane filter(const Plane& in, glm::ivec2 size, int radius,
             const std::function<double(double, double)>& kernel, bool unit_sum_by_sign) {
  double positive = 0, negative = 0;
  for (int j = -radius; j <= radius; ++j)
    for (int i = -radius; i <= radius; ++i) (kernel(i, j) > 0 ? positive : negative) += kernel(i, j);
  Plane out(in.size());
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x)
      for (int j = -radius; j <= radius; ++j)
        for (int i = -radius; i <= radius; ++i) {
          const double k = kernel(i, j), sum = k > 0 || !unit_sum_by_sign ? positive : -negative;
          const int column = std::clamp(x + i, 0, size.x - 1), row = std::clamp(y + j, 0, size.y - 1);
          out[std::size_t(y * size.x + x)] += k / sum * in[std::size_t(row * size.x + column)];
        }
  return out;
}

struct Xyz {
  double x, y, z;
};
Xyz relative_xyz(double r, double g, double b) {  // over white; IEC 61966-2-1's primaries, D65
  return {(0.4123870 * r + 0.3575914 * g + 0.1804501 * b) / 0.9504285,
          0.2126369 * r + 0.7151829 * g + 0.0721802 * b,
          (0.0193306 * r + 0.1191971 * g + 0.9503726 * b) / 1.0889003};
}

struct Seen {
  std::vector<Xyz> colors;  // L, a, b
  Plane edges, points;
};

double lab_root(double t) { return t > 216.0 / 24389 ? std::cbrt(t) : (24389.0 / 27 * t + 16) / 116; }

Xyz hunt_lab(double r, double g, double b) {
  const Xyz n = relative_xyz(r, g, b);
  const double fx = lab_root(n.x), fy = lab_root(n.y), fz = lab_root(n.z), lightness = 116 * fy - 16;
  return {lightness, 5 * lightness * (fx - fy), 2 * lightness * (fy - fz)};
}

Seen see(const Image& image, double ppd) {
  Plane y, cx, cz;
  const auto linear = [](double s) { return s > 0.04045 ? std::pow((s + 0.055) / 1.055, 2.4) : s / 12.92; };
  for (const glm::vec4& p : image.pixels) {
    const Xyz n = relative_xyz(linear(p.r), linear(p.g), linear(p.b));
    y.push_back(n.y);  // the Y of YCxCz is affine in this, which no filter minds
    cx.push_back(n.x - n.y);
    cz.push_back(n.y - n.z);
  }
  Seen seen;
  const double sd = 0.041 * ppd;
  const int feature_radius = int(std::ceil(3 * sd)), radius = int(std::ceil(3 * ppd * std::sqrt(0.02) / pi));
  const auto gauss = [=](double i, double j) { return std::exp(-(i * i + j * j) / (2 * sd * sd)); };
  const auto strength = [&](const std::function<double(double, double)>& kernel) {
    const Plane along = filter(y, image.size, feature_radius, kernel, true);
    const Plane across = filter(
        y, image.size, feature_radius, [&](double i, double j) { return kernel(j, i); }, true);
    Plane result;
    for (std::size_t i = 0; i < along.size(); ++i) result.push_back(std::hypot(along[i], across[i]));
    return result;
  };
  seen.edges = strength([&](double i, double j) { return -i * gauss(i, j); });
  seen.points = strength([&](double i, double j) { return (i * i / (sd * sd) - 1) * gauss(i, j); });

  const auto csf = [&](const Plane& channel, double a1, double b1, double a2, double b2) {
    const auto term = [=](double a, double b, double squared) {
      return a * std::sqrt(pi / b) * std::exp(-pi * pi * squared / b);
    };
    return filter(
        channel, image.size, radius,
        [=](double i, double j) {
          const double squared = (i * i + j * j) / (ppd * ppd);
          return term(a1, b1, squared) + term(a2, b2, squared);
        },
        false);
  };
  y = csf(y, 1, 0.0047, 0, 1e-5);
  cx = csf(cx, 1, 0.0053, 0, 1e-5);
  cz = csf(cz, 34.1, 0.04, 13.5, 0.025);
  for (std::size_t i = 0; i < y.size(); ++i) {
    const double X = (y[i] + cx[i]) * 0.9504285, Y = y[i], Z = (y[i] - cz[i]) * 1.0889003;
    const auto in_gamut = [](double v) { return std::clamp(v, 0.0, 1.0); };
    seen.colors.push_back(hunt_lab(in_gamut(3.2410033 * X - 1.5373989 * Y - 0.4986159 * Z),
                                   in_gamut(-0.9692243 * X + 1.8759301 * Y + 0.0415542 * Z),
                                   in_gamut(0.0556394 * X - 0.2040112 * Y + 1.0571489 * Z)));
  }
  return seen;
}

double distance(Xyz a, Xyz b) { return std::abs(a.x - b.x) + std::hypot(a.y - b.y, a.z - b.z); }

Plane flip(const Image& reference, const Image& test, double ppd) {
  const Seen a = see(reference, ppd), b = see(test, ppd);
  const double largest = std::pow(distance(hunt_lab(0, 1, 0), hunt_lab(0, 0, 1)), 0.7);
  Plane map;
  for (std::size_t i = 0; i < a.colors.size(); ++i) {
    const double d = std::pow(distance(a.colors[i], b.colors[i]), 0.7) / largest;
    const double color = d < 0.4 ? 0.95 * d / 0.4 : 0.95 + 0.05 * (d - 0.4) / 0.6;
    const double feature = std::max(std::abs(a.edges[i] - b.edges[i]), std::abs(a.points[i] - b.points[i]));
    map.push_back(std::pow(color, 1 - std::sqrt(feature / std::sqrt(2.0))));
  }
  return map;
}

}  // namespace slow

TEST(Flip, AgreesWithTheFormulasTakenLiterally) {
  for (const double ppd : {default_pixels_per_degree, 25.0}) {
    const Image a = random_squares({45, 33}, 6, 5);
    Image b = a;
    for (int y = 10; y < 20; ++y)
      for (int x = 5; x < 40; ++x) b.at(x, y) = 0.7f * b.at(x, y) + 0.1f;
    b.at(30, 25) = glm::vec4(1);
    const auto fast = flip_map(a, b, ppd);
    const auto expected = slow::flip(a, b, ppd);
    EXPECT_GT(*std::ranges::max_element(expected), 0.3);
    for (std::size_t i = 0; i < fast.size(); ++i) ASSERT_NEAR(fast[i], expected[i], 2e-3) << i;
  }
}

}  // namespace
}  // namespace crest
