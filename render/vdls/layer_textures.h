#pragma once

#include <array>
#include <glm/vec2.hpp>

#include "render/gl/render_target.h"

namespace crest {

/// The textures of a picture by VDLS (shaders/vdls_samples.glsl) with the framebuffers that draw into them
/// and into the picture: two of layer samples, of which one is read while the other is written, and one of
/// delta vectors.
class LayerTextures {
 public:
  /// Makes them for a picture of the target's size, if they are not there, and attaches the target.
  void attach(const gl::RenderTarget& target);

  GLuint layer_samples(int pass) const { return layers_[std::size_t(pass % 2)].id(); }  ///< read by a pass
  GLuint delta_vectors() const { return deltas_.id(); }
  GLuint setup_framebuffer() const { return setup_.id(); }  ///< writes layer_samples(0)
  GLuint pass_framebuffer(int pass) const {                 ///< writes layer_samples(pass + 1)
    return passes_[std::size_t(pass % 2)].id();
  }
  static std::size_t bytes(glm::ivec2 size) {
    return std::size_t(size.x) * std::size_t(size.y) * 3 * 4 * sizeof(GLint);
  }

 private:
  void make(glm::ivec2 size);

  glm::ivec2 size_{0};
  std::array<gl::TextureHandle, 2> layers_;
  gl::TextureHandle deltas_;
  gl::FramebufferHandle setup_;
  std::array<gl::FramebufferHandle, 2> passes_;
};

}  // namespace crest
