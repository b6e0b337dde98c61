#include "render/resources/shader_tf.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <utility>

#include "render/reference/levels.h"

namespace crest {
namespace {

using Levels = reference::Levels<double>;
constexpr float none = 3e38F;

/// A piece between two of its levels' places, or beyond the TF's ends.
struct Part {
  double low_value, high_value;
  bool has_low, has_high;
  glm::dvec4 low, high;  ///< colour and opacity
};

/// Where pieces are cut, as transparencies 1 - opacity.
constexpr double cuts[] = {0x1p-4, 0x1p-10, 0x1p-17};

glm::vec2 sum_of_two(double value) {
  const float high = float(value);
  return {high, value - double(high)};
}

ShaderTfPiece gpu_piece(const Part& part) {
  ShaderTfPiece piece{};
  piece.low = part.low;
  piece.rise = part.high - part.low;
  piece.low_value = part.has_low ? sum_of_two(part.low_value) : glm::vec2(-none, 0);
  piece.high_value = part.has_high ? sum_of_two(part.high_value) : glm::vec2(none, 0);
  return piece;
}

/// The part below and the part above the place where the transparency is `clear`.
std::pair<Part, Part> cut(const Part& part, double clear) {
  const double clear_low = 1 - part.low.a, clear_high = 1 - part.high.a;
  const double at = (clear_low - clear) / (clear_low - clear_high);
  Part below = part, above = part;
  below.high_value = above.low_value = std::lerp(part.low_value, part.high_value, at);
  below.has_high = above.has_low = true;
  below.high = above.low = glm::mix(part.low, part.high, at);
  below.high.a = above.low.a = 1 - clear;
  return {below, above};
}

/// A piece that shows nothing, with the next one that does not either.
void extend(ShaderTfPiece& piece, const ShaderTfPiece& next) { piece.high_value = next.high_value; }

bool is_clear(const ShaderTfPiece& piece) {
  return piece.low.a == 0 && piece.rise.a == 0 && piece.first_surface == piece.past_surface;
}

void add_part(std::vector<ShaderTfPiece>& pieces, const Part& part) {
  for (const double clear : cuts) {
    if (!(std::max(1 - part.low.a, 1 - part.high.a) > clear &&
          std::min(1 - part.low.a, 1 - part.high.a) < clear))
      continue;
    const auto [below, above] = cut(part, clear);
    add_part(pieces, below);
    return add_part(pieces, above);
  }
  const ShaderTfPiece piece = gpu_piece(part);
  if (!pieces.empty() && is_clear(pieces.back()) && is_clear(piece))
    extend(pieces.back(), piece);
  else
    pieces.push_back(piece);
}

/// What of the TF lies in the range, or a width of it beside it.
TransferFunction near(TransferFunction tf, ValueRange range) {
  range = with_width(range);
  const double low = range.min - range.width(), high = range.max + range.width();
  const auto point_at = [](double value, const Classified& material) {
    return ControlPoint{
        .value = value, .color = material.color, .opacity = material.opacity, .surface = {}, .unknown = {}};
  };
  std::vector<ControlPoint> points;
  if (!tf.points.empty() && tf.points.front().value < low)
    points.push_back(point_at(low, evaluate_right(tf, low)));
  for (const ControlPoint& point : tf.points)
    if (point.value >= low && point.value <= high) points.push_back(point);
  if (!tf.points.empty() && tf.points.back().value > high)
    points.push_back(point_at(high, evaluate_left(tf, high)));
  tf.points = std::move(points);
  return tf;
}

}  // namespace

ShaderTf shader_tf(const TransferFunction& tf, const std::vector<Peak>& surfaces, ValueRange field,
                   double smallest_spacing) {
  const Levels levels = reference::make_levels<double>(near(tf, field), surfaces, smallest_spacing);
  ShaderTf result;
  result.extinction_scale = float(levels.extinction_scale);
  for (std::size_t i = 0; i < levels.pieces.size(); ++i) {
    const auto& linear = levels.pieces[i];
    const auto* below = i > 0 ? &levels.levels[i - 1] : nullptr;
    const auto* above = i < levels.levels.size() ? &levels.levels[i] : nullptr;
    add_part(result.pieces, {.low_value = below ? below->value.hi + below->value.lo : 0,
                             .high_value = above ? above->value.hi + above->value.lo : 0,
                             .has_low = below != nullptr,
                             .has_high = above != nullptr,
                             .low = glm::dvec4(linear.color_low, linear.opacity_low),
                             .high = glm::dvec4(linear.color_high, linear.opacity_high)});
    if (!above) continue;
    result.pieces.back().first_surface = float(above->first_surface);
    result.pieces.back().past_surface = float(above->past_surface);
  }
  return result;
}

}  // namespace crest
