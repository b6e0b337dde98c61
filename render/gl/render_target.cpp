#include "render/gl/render_target.h"

#include <fmt/core.h>

#include "presets/error.h"

namespace crest::gl {
namespace {

TextureHandle make_texture(glm::ivec2 size, GLenum format) {
  GLuint id = 0;
  glCreateTextures(GL_TEXTURE_2D, 1, &id);
  TextureHandle texture(id);
  glTextureStorage2D(id, 1, format, size.x, size.y);
  glTextureParameteri(id, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTextureParameteri(id, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glTextureParameteri(id, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTextureParameteri(id, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  return texture;
}

}  // namespace

void require_size(glm::ivec2 size) {
  constexpr int largest = 16384;
  if (size.x < 1 || size.y < 1 || size.x > largest || size.y > largest)
    throw Error(fmt::format("a picture of {}x{} cannot be drawn: each side must be in 1..{}", size.x, size.y,
                            largest));
}

RenderTarget::RenderTarget(glm::ivec2 size, bool counts) : size_(size) {
  require_size(size);
  color_ = make_texture(size, GL_RGBA32F);
  GLuint id = 0;
  glCreateFramebuffers(1, &id);
  framebuffer_ = FramebufferHandle(id);
  glNamedFramebufferTexture(id, GL_COLOR_ATTACHMENT0, color_.id(), 0);
  if (counts) {
    counts_ = make_texture(size, GL_RGBA32UI);
    glNamedFramebufferTexture(id, GL_COLOR_ATTACHMENT1, counts_.id(), 0);
    const GLenum both[] = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1};
    glNamedFramebufferDrawBuffers(id, 2, both);
  }
  if (glCheckNamedFramebufferStatus(id, GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
    throw Error(fmt::format("the graphics driver has no room for a picture of {}x{}", size.x, size.y));
}

Image RenderTarget::read_color() const {
  Image image{size_, std::vector<glm::vec4>(std::size_t(size_.x) * std::size_t(size_.y))};
  glGetTextureImage(color_.id(), 0, GL_RGBA, GL_FLOAT, GLsizei(image.pixels.size() * sizeof(glm::vec4)),
                    image.pixels.data());
  return image;
}

std::vector<glm::uvec4> RenderTarget::read_counts() const {
  std::vector<glm::uvec4> counts(std::size_t(size_.x) * std::size_t(size_.y));
  glGetTextureImage(counts_.id(), 0, GL_RGBA_INTEGER, GL_UNSIGNED_INT,
                    GLsizei(counts.size() * sizeof(glm::uvec4)), counts.data());
  return counts;
}

}  // namespace crest::gl
