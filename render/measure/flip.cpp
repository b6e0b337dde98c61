#include "render/measure/flip.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/vec3.hpp>
#include <numbers>

namespace crest {
namespace {

using Plane = std::vector<float>;
using Kernel = std::vector<float>;  ///< weights of the offsets -radius..radius

constexpr double pi = std::numbers::pi;

// Colour spaces. Matrices are column-major.

const glm::dmat3 xyz_of_linear = glm::dmat3(10135552, 2613072 * 2, 1425312 / 3.0,  //
                                            8788810, 8788810 * 2, 8788810 / 3.0,   //
                                            4435075, 887015 * 2, 70074185 / 3.0) /
                                 24577794.0;
const glm::dmat3 linear_of_xyz = glm::inverse(xyz_of_linear);
const glm::dvec3 white = xyz_of_linear * glm::dvec3(1);  ///< D65

double linear_of_srgb(double x) { return x > 0.04045 ? std::pow((x + 0.055) / 1.055, 2.4) : x / 12.92; }

/// Linear counterparts of L*a*b*: luminance Y, and the opponent axes Cx (red-green) and Cz (blue-yellow).
glm::dvec3 ycxcz_of_linear(glm::dvec3 linear) {
  const glm::dvec3 n = xyz_of_linear * linear / white;
  return {116 * n.y - 16, 500 * (n.x - n.y), 200 * (n.y - n.z)};
}

glm::dvec3 linear_of_ycxcz(glm::dvec3 c) {
  const double y = (c.x + 16) / 116;
  return linear_of_xyz * (glm::dvec3(y + c.y / 500, y, y - c.z / 200) * white);
}

/// L*a*b*, with a* and b* scaled by lightness: colours look less different in the dark (Hunt effect).
glm::dvec3 hunt_lab_of_linear(glm::dvec3 linear) {
  constexpr double delta = 6.0 / 29;
  glm::dvec3 n = xyz_of_linear * linear / white;
  for (int i = 0; i < 3; ++i)
    n[i] = n[i] > delta * delta * delta ? std::cbrt(n[i]) : n[i] / (3 * delta * delta) + 4.0 / 29;
  const double lightness = 116 * n.y - 16;
  return {lightness, 0.01 * lightness * 500 * (n.x - n.y), 0.01 * lightness * 200 * (n.y - n.z)};
}

double hyab_distance(glm::dvec3 a, glm::dvec3 b) {
  const glm::dvec3 d = a - b;
  return std::abs(d.x) + std::hypot(d.y, d.z);
}

// Filters. Each is a product of one along x and one along y; beyond the border the image repeats its edge.

Kernel kernel_of(int radius, const auto& weight) {
  Kernel kernel;
  for (int i = -radius; i <= radius; ++i) kernel.push_back(float(weight(double(i))));
  return kernel;
}

/// Positive weights sum to 1, negative ones to -1.
Kernel normalized(Kernel kernel) {
  double positive = 0, negative = 0;
  for (const float w : kernel) (w > 0 ? positive : negative) += std::abs(double(w));
  for (float& w : kernel) w = float(w / (w > 0 ? positive : negative));
  return kernel;
}

Plane convolve(const Plane& in, glm::ivec2 size, const Kernel& along_x, const Kernel& along_y) {
  Plane middle(in.size()), out(in.size());
  const int rx = int(along_x.size() / 2), ry = int(along_y.size() / 2);
  const auto at = [&](int x, int y) { return std::size_t(y) * std::size_t(size.x) + std::size_t(x); };
  tbb::parallel_for(0, size.y, [&](int y) {
    for (int x = 0; x < size.x; ++x) {
      float sum = 0;
      for (int i = -rx; i <= rx; ++i)
        sum += along_x[std::size_t(i + rx)] * in[at(std::clamp(x + i, 0, size.x - 1), y)];
      middle[at(x, y)] = sum;
    }
  });
  tbb::parallel_for(0, size.y, [&](int y) {
    for (int i = -ry; i <= ry; ++i) {
      const float weight = along_y[std::size_t(i + ry)];
      const std::size_t row = at(0, std::clamp(y + i, 0, size.y - 1));
      for (int x = 0; x < size.x; ++x) out[at(x, y)] += weight * middle[row + std::size_t(x)];
    }
  });
  return out;
}

/// One channel's contrast sensitivity: a sum of Gaussians a * sqrt(pi/b) * exp(-pi^2 r^2 / b), r in degrees
/// (their table 1). Being separable only one by one, each is filtered with by itself.
struct Sensitivity {
  double a, b;
};
const std::vector<Sensitivity> sensitivities[3] = {
    {{1, 0.0047}}, {{1, 0.0053}}, {{34.1, 0.04}, {13.5, 0.025}}};
constexpr double widest_b = 0.04;

Plane see(const Plane& channel, glm::ivec2 size, const std::vector<Sensitivity>& sensitivity,
          double pixels_per_degree) {
  const int radius = int(std::ceil(3 * std::sqrt(widest_b / (2 * pi * pi)) * pixels_per_degree));
  Plane sum(channel.size());
  double total = 0;
  for (const auto [a, b] : sensitivity) {
    const Kernel gauss =
        kernel_of(radius, [&](double i) { return std::exp(-std::pow(pi * i / pixels_per_degree, 2) / b); });
    double weight = 0;
    for (const float w : gauss) weight += w;
    weight *= weight * a * std::sqrt(pi / b);
    total += weight;
    const Plane part = convolve(channel, size, normalized(gauss), normalized(gauss));
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += float(weight) * part[i];
  }
  for (float& value : sum) value /= float(total);
  return sum;
}

/// What the eye makes of a picture: perceived colours, and the strength of edges and of points.
struct Percept {
  std::vector<glm::vec3> colors;  ///< L*a*b*, Hunt-adjusted
  Plane edges, points;
};

Plane strength(const Plane& luminance, glm::ivec2 size, const Kernel& feature, const Kernel& smooth) {
  const Plane x = convolve(luminance, size, feature, smooth), y = convolve(luminance, size, smooth, feature);
  Plane result(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) result[i] = std::hypot(x[i], y[i]);
  return result;
}

Percept perceive(const Image& image, double pixels_per_degree) {
  Plane channels[3], luminance;
  for (Plane& channel : channels) channel.resize(image.pixels.size());
  tbb::parallel_for(std::size_t(0), image.pixels.size(), [&](std::size_t i) {
    glm::dvec3 linear = glm::clamp(glm::dvec3(image.pixels[i]), 0.0, 1.0);
    for (int c = 0; c < 3; ++c) linear[c] = linear_of_srgb(linear[c]);
    const glm::dvec3 ycxcz = ycxcz_of_linear(linear);
    for (int c = 0; c < 3; ++c) channels[c][i] = float(ycxcz[c]);
  });
  for (const float y : channels[0]) luminance.push_back((y + 16) / 116);
  for (int c = 0; c < 3; ++c) channels[c] = see(channels[c], image.size, sensitivities[c], pixels_per_degree);

  Percept percept;
  percept.colors.resize(image.pixels.size());
  tbb::parallel_for(std::size_t(0), image.pixels.size(), [&](std::size_t i) {
    const glm::dvec3 linear = linear_of_ycxcz({channels[0][i], channels[1][i], channels[2][i]});
    percept.colors[i] = hunt_lab_of_linear(glm::clamp(linear, 0.0, 1.0));
  });

  const double deviation = 0.5 * 0.082 * pixels_per_degree;  // half a feature's width in degrees
  const int radius = int(std::ceil(3 * deviation));
  const auto gauss = [&](double i) { return std::exp(-i * i / (2 * deviation * deviation)); };
  const Kernel smooth = normalized(kernel_of(radius, gauss));
  const Kernel edge = normalized(kernel_of(radius, [&](double i) { return -i * gauss(i); }));
  const Kernel point = normalized(
      kernel_of(radius, [&](double i) { return (i * i / (deviation * deviation) - 1) * gauss(i); }));
  percept.edges = strength(luminance, image.size, edge, smooth);
  percept.points = strength(luminance, image.size, point, smooth);
  return percept;
}

/// Their section 4.1.3: large differences are all much the same.
double color_difference(glm::dvec3 a, glm::dvec3 b) {
  constexpr double exponent = 0.7, knee = 0.4, knee_value = 0.95;
  static const double largest =
      std::pow(hyab_distance(hunt_lab_of_linear({0, 1, 0}), hunt_lab_of_linear({0, 0, 1})), exponent);
  const double difference = std::pow(hyab_distance(a, b), exponent), bend = knee * largest;
  return difference < bend ? knee_value / bend * difference
                           : knee_value + (difference - bend) / (largest - bend) * (1 - knee_value);
}

}  // namespace

std::vector<float> flip_map(const Image& reference, const Image& test, double pixels_per_degree) {
  const Percept a = perceive(reference, pixels_per_degree), b = perceive(test, pixels_per_degree);
  std::vector<float> map(a.colors.size());
  tbb::parallel_for(std::size_t(0), map.size(), [&](std::size_t i) {
    const double feature =
        std::max(std::abs(a.edges[i] - b.edges[i]), std::abs(a.points[i] - b.points[i])) / std::sqrt(2.0);
    map[i] = float(std::pow(color_difference(a.colors[i], b.colors[i]), 1 - std::sqrt(feature)));
  });
  return map;
}

}  // namespace crest
