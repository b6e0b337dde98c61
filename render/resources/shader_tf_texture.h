#pragma once

#include "render/gl/handle.h"
#include "render/resources/keyed_cache.h"
#include "render/resources/shader_tf.h"

namespace crest {

/// The pieces on the GPU.
struct ShaderTfTexture {
  gl::BufferHandle buffer;
  gl::TextureHandle texture;  ///< by which shaders read it: four RGBA32F texels a piece
  int count = 0;
  float extinction_scale = 1;
};

/// As shader_tf. Throws Error for more than the driver holds.
const ShaderTfTexture& shader_tf_texture(KeyedCache& held, const TransferFunction& tf,
                                         const std::vector<Peak>& surfaces, ValueRange field,
                                         double smallest_spacing);

}  // namespace crest
