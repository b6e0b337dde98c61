#include "render/gl/render_target.h"

#include <fmt/core.h>

#include <algorithm>

#include "presets/error.h"
#include "render/gl/errors.h"
#include "render/gl/texture.h"

namespace crest::gl {
namespace {

TextureHandle make_texture(glm::ivec2 size, GLenum format) {
  TextureHandle texture = gl::make_texture(GL_TEXTURE_2D, GL_NEAREST);
  glTextureStorage2D(texture.id(), 1, format, size.x, size.y);
  return texture;
}

/// Reads a texture of four 32-bit channels, some rows at a time.
template <class Pixel>
std::vector<Pixel> read_pixels(GLuint texture, glm::ivec2 size, GLenum format, GLenum type,
                               std::size_t part_bytes) {
  std::vector<Pixel> pixels(std::size_t(size.x) * std::size_t(size.y));
  const std::size_t row_bytes = std::size_t(size.x) * sizeof(Pixel);
  const int rows = int(std::clamp(part_bytes / row_bytes, std::size_t(1), std::size_t(size.y)));
  require_no_error("drawing", size);
  for (int row = 0; row < size.y; row += rows) {
    const int count = std::min(rows, size.y - row);
    glGetTextureSubImage(texture, 0, 0, row, 0, size.x, count, 1, format, type,
                         GLsizei(std::size_t(count) * row_bytes),
                         pixels.data() + std::size_t(row) * std::size_t(size.x));
  }
  require_no_error("reading back", size);
  return pixels;
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
  forget_errors();
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
  require_no_error("making room for", size);
  if (glCheckNamedFramebufferStatus(id, GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
    throw Error(fmt::format("the graphics driver has no room for a picture of {}x{}", size.x, size.y));
}

Image RenderTarget::read_color(std::size_t part_bytes) const {
  return {size_, read_pixels<glm::vec4>(color_.id(), size_, GL_RGBA, GL_FLOAT, part_bytes)};
}

std::vector<glm::uvec4> RenderTarget::read_counts(std::size_t part_bytes) const {
  return read_pixels<glm::uvec4>(counts_.id(), size_, GL_RGBA_INTEGER, GL_UNSIGNED_INT, part_bytes);
}

}  // namespace crest::gl
