#pragma once

#include <vector>

#include "render/classify/peak_table.h"
#include "render/classify/tf_table.h"
#include "render/gl/handle.h"
#include "render/resources/keyed_cache.h"

namespace crest {

// All values here are in the volume's stored units (stored_units.h), in which the GPU has them.

/// A TF on the GPU: 1D, RGBA32F, the first and the last entry's centres are the range's ends.
struct TfTexture {
  gl::TextureHandle texture;
  ValueRange range;
  int entries = 0;
};

/// `tf` is resolved; the texture covers what `field` reaches of it (see build_tf_table).
const TfTexture& tf_texture(KeyedCache& held, const TransferFunction& tf, ValueRange field,
                            double smallest_spacing, int entries);

/// Gives it to a program with transfer_function.glsl, in this texture unit.
void bind_tf_texture(GLuint program, const TfTexture& tf, GLuint unit);

/// The peak table's two arrays on the GPU: 1D, RGBA32F, a texel a bin. x and z are the isovalue and the index
/// of the first peak that may be in the bin or above it, y and w the isovalue of the last one that may be in
/// it or below and one past its index. The isovalue is infinity, or -infinity, where there is no such peak.
struct PeakTableTexture {
  gl::TextureHandle texture;
  ValueRange range;  ///< of the field
  int bins = 0;
  float bin_scale = 0;
};
/// Of `surfaces`, by value, in a field of this range.
const PeakTableTexture& peak_table_texture(KeyedCache& held, const std::vector<Peak>& surfaces,
                                           ValueRange field, int bins);

/// The peaks in the std430 layout of shaders/peaks.glsl; where there is none, one that is never met.
GLuint peak_buffer(KeyedCache& held, const std::vector<Peak>& peaks);

}  // namespace crest
