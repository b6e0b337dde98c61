#pragma once

#include <vector>

#include "render/classify/peak_table.h"
#include "render/classify/tf_table.h"
#include "render/gl/handle.h"

namespace crest {

/// A TF on the GPU: 1D, RGBA32F, the first and the last entry's centres are the range's ends.
struct TfTexture {
  gl::TextureHandle texture;
  ValueRange range;
  int entries = 0;
};

/// `tf` is resolved; the texture covers what `field` reaches of it (see build_tf_table).
TfTexture upload_tf(const TransferFunction& tf, ValueRange field, double smallest_spacing, int entries);

/// Gives it to a program with transfer_function.glsl, in this texture unit.
void bind_tf_texture(GLuint program, const TfTexture& tf, GLuint unit);

/// The peak table on the GPU, entry bin across, exit bin up.
struct PeakTableTextures {
  int bins = 0;
  ValueRange range;  ///< of the field, in its own units
  float bin_scale = 0;
  gl::TextureHandle
      ranges;  ///< RG32F: the least and the greatest isovalue of a cell; (inf, -inf) where there is none
  gl::TextureHandle runs;  ///< R32UI: the first candidate in the lower 16 bits, their count in the upper
};
PeakTableTextures upload_peak_table(const PeakTable& table, const std::vector<Peak>& peaks);

/// The peaks in the std430 layout of shaders/peaks.glsl; where there is none, one that is never met.
gl::BufferHandle upload_peaks(const std::vector<Peak>& peaks);

}  // namespace crest
