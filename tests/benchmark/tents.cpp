#include "tests/benchmark/tents.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace crest::bench {
namespace {

double longest_side(const Grid& grid) {
  const glm::dvec3 size = grid.box_size();
  return std::max({size.x, size.y, size.z});
}

}  // namespace

std::vector<double> tent_widths(int count) {
  constexpr double power = 0.1;
  const double first = std::pow(0.05, power), last = std::pow(0.002, power);
  std::vector<double> widths;
  for (int i = 0; i < count; ++i)
    widths.push_back(std::pow(std::lerp(first, last, i / std::max(count - 1.0, 1.0)), 1 / power));
  return widths;
}

TransferFunction tent(const Volume& volume, double isovalue, double width, double scaling) {
  constexpr double tip = 1e-3;
  // The mean of -ln(1 - a) between 0 and the tip, and that of the linear extinction, half of its tip's
  const double mean_depth = ((1 - tip) * std::log1p(-tip) + tip) / tip;
  const double mean_extinction = 0.5 * scaling * 0.05 / width / longest_side(volume.grid);
  const ValueRange range = volume.statistics.range;
  TransferFunction tf;
  tf.unit_distance = mean_depth / mean_extinction;
  for (const int side : {-1, 0, 1}) {
    ControlPoint point;
    point.value = range.min + (isovalue + side * width) * range.width();
    point.color = {0.9, 0.35, 0.1};
    point.opacity = side == 0 ? tip : 0;
    tf.points.push_back(point);
  }
  return tf;
}

TransferFunction as_texture(const TransferFunction& tf, ValueRange range, int texels) {
  TransferFunction texture = tf;
  texture.points.clear();
  for (int i = 0; i < texels; ++i) {
    ControlPoint point;
    point.value = range.min + (i + 0.5) / texels * range.width();
    const Classified at = evaluate(tf, point.value);
    point.color = at.color;
    point.opacity = at.opacity;
    texture.points.push_back(point);
  }
  return texture;
}

ChangedShaders stepping_shaders(const Grid& grid) {
  const double least = 1e-4 * grid.smallest_spacing() / longest_side(grid);
  return ChangedShaders(
      {{"raycaster.frag", "composite(material.rgb * DVR_LIGHT(t), opacity_of(material.a * size_at(s, i)));",
        fmt::format("if (material.a > {}) composite(material.rgb, min(material.a * s.dt, 1.0));", least)},
       {"placement.glsl",
        "return equal_segments(span, max(LEAST_SEGMENTS, int(ceil(steps - 0.5))), step_length, span.enter);",
        // the march samples in the middle of what begins half a step early
        "return equal_segments(span, int(ceil(steps)), step_length, span.enter - 0.5 * step_length);"}});
}

WhiteError error_over_white(const Image& a, const Image& b) {
  const Image over_a = over_background(a, glm::vec3(1)), over_b = over_background(b, glm::vec3(1));
  WhiteError error;
  const auto count = double(over_a.pixels.size());
  for (std::size_t i = 0; i < over_a.pixels.size(); ++i) {
    const glm::vec4 off = glm::abs(over_a.pixels[i] - over_b.pixels[i]);
    const double most = std::max({off.r, off.g, off.b});
    error.mean += (double(off.r) + double(off.g) + double(off.b)) / (3 * count);
    error.largest = std::max(error.largest, most);
    if (most > 1.0 / 255) error.share += 1 / count;
  }
  return error;
}

}  // namespace crest::bench
