#include "render/resources/shader_tf.h"

#include <algorithm>
#include <glm/common.hpp>

#include "render/reference/levels.h"

namespace crest {
namespace {

using Levels = reference::Levels<double>;
constexpr float none = 3e38F;

/// A piece between two of its levels' places, or beyond the TF's ends.
struct Part {
  double low_value, high_value, width;
  bool has_low, has_high;
  glm::dvec4 low, high;  ///< colour and opacity
};

/// Where pieces are cut, as transparencies 1 - opacity.
constexpr double cuts[] = {0x1p-4, 0x1p-10, 0x1p-17};

ShaderTfPiece gpu_piece(const Part& part) {
  ShaderTfPiece piece{};
  piece.low = part.low;
  piece.rise = part.high - part.low;
  piece.high_value = part.has_high ? float(part.high_value) : none;
  piece.base = part.has_low ? float(part.low_value) : part.has_high ? piece.high_value : 0;
  piece.most = !part.has_high ? none : part.has_low ? float(part.width) : 0;
  piece.inverse_width = part.has_low && part.has_high ? float(1 / part.width) : 0;
  return piece;
}

/// The part below and the part above the place where the transparency is `clear`.
std::pair<Part, Part> cut(const Part& part, double clear) {
  const double clear_low = 1 - part.low.a, clear_high = 1 - part.high.a;
  const double at = (clear_low - clear) / (clear_low - clear_high);
  Part below = part, above = part;
  below.width = part.width * at;
  above.width = part.width * (1 - at);
  below.high_value = above.low_value = part.low_value + below.width;
  below.has_high = above.has_low = true;
  below.high = above.low = glm::mix(part.low, part.high, at);
  below.high.a = above.low.a = 1 - clear;
  return {below, above};
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
  pieces.push_back(gpu_piece(part));
}

}  // namespace

ShaderTf shader_tf(const TransferFunction& tf, const std::vector<Peak>& surfaces, double smallest_spacing) {
  const Levels levels = reference::make_levels<double>(tf, surfaces, smallest_spacing);
  ShaderTf result;
  result.extinction_scale = float(levels.extinction_scale);
  for (std::size_t i = 0; i < levels.pieces.size(); ++i) {
    const auto& linear = levels.pieces[i];
    const auto* below = i > 0 ? &levels.levels[i - 1] : nullptr;
    const auto* above = i < levels.levels.size() ? &levels.levels[i] : nullptr;
    add_part(result.pieces, {.low_value = below ? below->value.hi : 0,
                             .high_value = above ? above->value.hi : 0,
                             .width = below && above ? above->value - below->value : 0,
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
