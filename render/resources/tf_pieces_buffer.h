#pragma once

#include "render/gl/handle.h"
#include "render/resources/keyed_cache.h"
#include "render/resources/tf_pieces.h"

namespace crest {

/// The pieces on the GPU.
struct TfPiecesTexture {
  gl::BufferHandle buffer;
  gl::TextureHandle texture;  ///< by which shaders read it: six RGBA32F texels a piece
  int count = 0;
  float extinction_scale = 1;
};

/// As build_tf_pieces. Throws Error for more than the driver holds.
const TfPiecesTexture& tf_pieces_texture(KeyedCache& held, const TransferFunction& tf,
                                         const std::vector<Peak>& surfaces, double smallest_spacing);

}  // namespace crest
