#pragma once

#include <vector>

#include "presets/peaks.h"
#include "presets/transfer_function.h"
#include "render/gl/handle.h"
#include "render/resources/keyed_cache.h"

namespace crest {

/// A TF and surfaces on the GPU as the pieces of reference::Levels, without a table: the std430 layout of
/// shaders/tf_pieces.glsl. What is narrow is kept as a difference, so that a spike of 1e-12 of the range is
/// as exact as a wide one.
struct TfPieces {
  gl::BufferHandle buffer;
  int count = 0;               ///< at least 1
  float extinction_scale = 1;  ///< -log(1 - opacity) times this is the extinction per smallest spacing
};

inline constexpr std::size_t bytes_of_tf_piece = 64;

/// All values are in the volume's stored units (stored_units.h). `tf` is resolved, and may have no points;
/// `surfaces` are by ascending value, as in peak_buffer.
const TfPieces& tf_pieces(KeyedCache& held, const TransferFunction& tf, const std::vector<Peak>& surfaces,
                          double smallest_spacing);

}  // namespace crest
