#include "render/vdls/layer_textures.h"

#include <fmt/core.h>

#include "presets/error.h"
#include "render/gl/texture.h"

namespace crest {
namespace {

gl::TextureHandle make_texture(glm::ivec2 size) {
  gl::TextureHandle texture = gl::make_texture(GL_TEXTURE_2D, GL_NEAREST);
  glTextureStorage2D(texture.id(), 1, GL_RGBA32I, size.x, size.y);
  return texture;
}

gl::FramebufferHandle make_framebuffer() {
  GLuint id = 0;
  glCreateFramebuffers(1, &id);
  return gl::FramebufferHandle(id);
}

/// Draws into these textures, of which those that are 0 are left out.
void attach_all(GLuint framebuffer, std::initializer_list<GLuint> textures) {
  std::array<GLenum, 4> buffers{};
  GLsizei count = 0;
  for (const GLuint texture : textures) {
    const GLenum attachment = GL_COLOR_ATTACHMENT0 + GLenum(count);
    glNamedFramebufferTexture(framebuffer, attachment, texture, 0);
    buffers[std::size_t(count++)] = texture ? attachment : GL_NONE;
  }
  glNamedFramebufferDrawBuffers(framebuffer, count, buffers.data());
}

}  // namespace

void LayerTextures::make(glm::ivec2 size) {
  *this = LayerTextures();  // the old ones' room first
  for (auto& texture : layers_) texture = make_texture(size);
  deltas_ = make_texture(size);
  setup_ = make_framebuffer();
  for (auto& framebuffer : passes_) framebuffer = make_framebuffer();
  size_ = size;
}

void LayerTextures::attach(const gl::RenderTarget& target) {
  if (size_ != target.size()) make(target.size());
  attach_all(setup_.id(), {target.color_texture(), layers_[0].id(), deltas_.id(), target.counts_texture()});
  for (std::size_t pass = 0; pass < 2; ++pass)
    attach_all(passes_[pass].id(), {target.color_texture(), layers_[1 - pass].id()});
  for (const GLuint framebuffer : {setup_.id(), passes_[0].id(), passes_[1].id()})
    if (glCheckNamedFramebufferStatus(framebuffer, GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
      throw Error(fmt::format("the graphics driver has no room for the layers of a picture of {}x{}", size_.x,
                              size_.y));
}

}  // namespace crest
