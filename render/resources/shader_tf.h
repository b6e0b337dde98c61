#pragma once

#include <glm/vec4.hpp>
#include <vector>

#include "presets/peaks.h"
#include "presets/transfer_function.h"

namespace crest {

/// A linear piece of a TF as shaders/tf_pieces.glsl reads it: four RGBA32F texels.
struct ShaderTfPiece {
  glm::vec4 low, rise;  ///< colour and opacity at its lower level, and how much more at its upper one
  float base;  ///< offsets are from this value: the lower level's, or in the first piece the upper one's
  float most;  ///< offset of its upper level; 3e38 where there is none
  float inverse_width;                ///< of the offsets; 0 beyond the TF's ends
  float high_value;                   ///< the upper level's own, rounded; 3e38 where there is none
  float first_surface, past_surface;  ///< indices of those of the level above it
  float unused[2];
};

/// A TF and surfaces, cut as reference::Levels cuts them, and where opacity comes so near to 1 that the depth
/// has no good polynomial. At least one piece; what is narrow is kept as a difference, so that a spike of
/// 1e-12 of the range is as exact as a wide one.
struct ShaderTf {
  std::vector<ShaderTfPiece> pieces;
  float extinction_scale = 1;  ///< -log(1 - opacity) times this is the extinction per smallest spacing
};

/// All values are in the volume's stored units (stored_units.h). `tf` is resolved, and may have no points;
/// `surfaces` are by ascending value, and are counted from the first.
ShaderTf shader_tf(const TransferFunction& tf, const std::vector<Peak>& surfaces, double smallest_spacing);

}  // namespace crest
