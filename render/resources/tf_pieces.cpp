#include "render/resources/tf_pieces.h"

#include <cmath>
#include <glm/common.hpp>
#include <numbers>

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

bool is_steep(double opacity_low, double opacity_high) {
  const double a = 1 - opacity_low, b = 1 - opacity_high;
  return std::max(a, b) > steepest * std::min(a, b);
}

TfPiece gpu_piece(const Part& part) {
  TfPiece piece{};
  piece.low = part.low;
  piece.rise = part.high - part.low;
  piece.low_value = part.has_low ? float(part.low_value) : -none;
  piece.high_value = part.has_high ? float(part.high_value) : none;
  piece.base = part.has_low ? piece.low_value : part.has_high ? piece.high_value : 0;
  piece.least = part.has_low ? 0 : -none;
  piece.most = !part.has_high ? none : part.has_low ? float(part.width) : 0;
  piece.inverse_width = part.has_low && part.has_high ? float(1 / part.width) : 0;
  if (!is_steep(part.low.a, part.high.a)) piece.depth = depth_polynomial(part.low.a, part.high.a);
  return piece;
}

/// In two where it is steep: at 1 - opacity = 1/steepest of what it is at the clearer end.
void add_part(std::vector<TfPiece>& pieces, const Part& part) {
  if (!is_steep(part.low.a, part.high.a)) return pieces.push_back(gpu_piece(part));
  const double clear_low = 1 - part.low.a, clear_high = 1 - part.high.a;
  const double clear = std::max(clear_low, clear_high) / steepest;
  const double at = (clear_low - clear) / (clear_low - clear_high);
  Part below = part, above = part;
  below.width = part.width * at;
  above.width = part.width * (1 - at);
  below.high_value = above.low_value = part.low_value + below.width;
  below.has_high = above.has_low = true;
  below.high = above.low = glm::mix(part.low, part.high, at);
  below.high.a = above.low.a = 1 - clear;
  pieces.push_back(gpu_piece(below));
  pieces.push_back(gpu_piece(above));
}

}  // namespace

TfPieces build_tf_pieces(const TransferFunction& tf, const std::vector<Peak>& surfaces, double smallest_spacing) {
  const Levels levels = reference::make_levels<double>(tf, surfaces, smallest_spacing);
  TfPieces result;
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

std::array<float, 8> depth_polynomial(double opacity_low, double opacity_high) {
  constexpr std::size_t n = 8;
  double chebyshev[n] = {};  // coefficients of T_k
  for (std::size_t i = 0; i < n; ++i) {
    const double angle = std::numbers::pi * (double(i) + 0.5) / n;
    const double a = std::lerp(opacity_low, opacity_high, 0.5 + 0.5 * std::cos(angle));
    const double value = a < 1e-8 ? 1 + a / 2 : -std::log1p(-a) / a;
    for (std::size_t k = 0; k < n; ++k) chebyshev[k] += (k == 0 ? 1.0 : 2.0) / n * value * std::cos(double(k) * angle);
  }
  double sum[n] = {}, before[n] = {1}, now[n] = {0, 1};  // T_0 and T_1 by powers of x
  for (std::size_t k = 0; k < n; ++k) {
    for (std::size_t j = 0; j < n; ++j) sum[j] += chebyshev[k] * before[j];
    double next[n];
    for (std::size_t j = 0; j < n; ++j) next[j] = (j > 0 ? 2 * now[j - 1] : 0) - before[j];
    std::copy(now, now + n, before);
    std::copy(next, next + n, now);
  }
  return {float(sum[0]), float(sum[2]), float(sum[4]), float(sum[6]),
          float(sum[1]), float(sum[3]), float(sum[5]), float(sum[7])};
}

}  // namespace crest
