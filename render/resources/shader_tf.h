#pragma once

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <vector>

#include "presets/peaks.h"
#include "presets/transfer_function.h"

namespace crest {

/// A linear piece of a TF as shaders/tf_pieces.glsl reads it: four RGBA32F texels.
struct ShaderTfPiece {
  glm::vec4 low, rise;  ///< colour and opacity at its lower level, and how much more at its upper one
  glm::vec2 low_value, high_value;    ///< of its levels, as sums of two; -3e38 and 3e38 where there is none
  float first_surface, past_surface;  ///< indices of those of the level above it
  float unused[2];
};

/// A TF and surfaces, cut as reference::Levels cuts them, and where opacity comes near to 1: there -log(1 -
/// a) is steep, and Simpson's rule would need many panels. What lies side by side and shows nothing is one
/// piece. At least one piece; what is narrow is kept as a difference, so that a spike of 1e-12 of the range
/// is as exact as a wide one.
struct ShaderTf {
  std::vector<ShaderTfPiece> pieces;
  float extinction_scale = 1;  ///< -log(1 - opacity) times this is the extinction per smallest spacing
};

/// All values are in the volume's stored units (stored_units.h). `tf` is resolved, and may have no points;
/// `surfaces` are by ascending value, and are counted from the first. No value is beyond `field`: what the TF
/// has far beyond it is left out, since 32-bit offsets from there would be coarse.
ShaderTf shader_tf(const TransferFunction& tf, const std::vector<Peak>& surfaces, ValueRange field,
                   double smallest_spacing);

}  // namespace crest
