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

/// The peak table on the GPU, entry bin across, exit bin up.
struct PeakTableTextures {
  int bins = 0;
  ValueRange range;  ///< of the field
  float bin_scale = 0;
  gl::TextureHandle
      ranges;  ///< RG32F: the least and the greatest isovalue of a cell; (inf, -inf) where there is none
  gl::TextureHandle runs;  ///< R32UI: the first candidate in the lower 16 bits, their count in the upper
};
/// Of `surfaces`, by value, in a field of this range.
const PeakTableTextures& peak_table_textures(KeyedCache& held, const std::vector<Peak>& surfaces,
                                             ValueRange field, int bins);

/// The peaks in the std430 layout of shaders/peaks.glsl; where there is none, one that is never met.
GLuint peak_buffer(KeyedCache& held, const std::vector<Peak>& peaks);

}  // namespace crest
