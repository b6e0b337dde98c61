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

/// The peak table's two arrays on the GPU: 1D, RGBA32F, a texel a bin. x and z are the isovalue and the index
/// of the first peak that may be in the bin or above it, y and w the isovalue of the last one that may be in
/// it or below and one past its index. The isovalue is infinity, or -infinity, where there is no such peak.
struct PeakTableTexture {
  gl::TextureHandle texture;
  ValueRange range;  ///< of the field, in its own units
  int bins = 0;
  float bin_scale = 0;
};
/// `peaks` are the table's, in the units that the shader sees.
PeakTableTexture upload_peak_table(const PeakTable& table, const std::vector<Peak>& peaks);

/// The peaks in the std430 layout of shaders/peaks.glsl; where there is none, one that is never met.
gl::BufferHandle upload_peaks(const std::vector<Peak>& peaks);

}  // namespace crest
