#pragma once

#include <array>
#include <glm/vec4.hpp>
#include <vector>

#include "presets/peaks.h"
#include "presets/transfer_function.h"

namespace crest {

/// A linear piece of a TF as shaders/tf_pieces.glsl reads it: six RGBA32F texels.
struct TfPiece {
  glm::vec4 low, rise;  ///< colour and opacity at its lower level, and how much more at its upper one
  float base;           ///< offsets are from this value: the lower level's, or in the first piece the upper one's
  float least, most;    ///< offsets of its levels; -3e38 and 3e38 where there is none
  float inverse_width;  ///< of the offsets; 0 beyond the TF's ends
  float low_value, high_value;         ///< the levels' own, rounded
  float first_surface, past_surface;   ///< indices of those of the level above it
  std::array<float, 8> depth;          ///< see depth_polynomial: of x^0, x^2, x^4, x^6, x^1, x^3, x^5, x^7
};

/// A TF and surfaces, cut as reference::Levels cuts them, and where opacity comes so near to 1 that the depth has no
/// good polynomial. At least one piece; what is narrow is kept as a difference, so that a spike of 1e-12 of the range
/// is as exact as a wide one.
struct TfPieces {
  std::vector<TfPiece> pieces;
  float extinction_scale = 1;  ///< -log(1 - opacity) times this is the extinction per smallest spacing
};

/// All values are in the volume's stored units (stored_units.h). `tf` is resolved, and may have no points; `surfaces`
/// are by ascending value, and are counted from the first.
TfPieces build_tf_pieces(const TransferFunction& tf, const std::vector<Peak>& surfaces, double smallest_spacing);

/// Between two opacities a, -log(1 - a) / a as a polynomial in x from -1 to 1, that of Chebyshev's nodes. `opacity_low`
/// may be the greater one. Where 1 - a is at the one end no more than steepest times what it is at the other, the depth
/// that follows is right to 2e-3, and to 4e-5 where it is 4 times.
std::array<float, 8> depth_polynomial(double opacity_low, double opacity_high);
inline constexpr double steepest = 16;

}  // namespace crest
