#include "render/gl/pending_read.h"

#include "render/gl/errors.h"

namespace crest::gl {
namespace {

struct Layout {
  GLenum attachment, format, type;
  std::size_t bytes;  ///< a pixel
};

// glReadPixels into a buffer waits on no driver of a graphics card; of glGetTextureSubImage some are not so
// sure.
PendingBuffer copied(GLuint framebuffer, glm::ivec2 size, const Layout& layout) {
  forget_errors();
  GLuint id = 0;
  glCreateBuffers(1, &id);
  BufferHandle buffer(id);
  glNamedBufferStorage(id, GLsizeiptr(size.x) * size.y * GLsizeiptr(layout.bytes), nullptr, 0);
  glNamedFramebufferReadBuffer(framebuffer, layout.attachment);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer);
  glBindBuffer(GL_PIXEL_PACK_BUFFER, id);
  glReadPixels(0, 0, size.x, size.y, layout.format, layout.type, nullptr);
  glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
  PendingBuffer pending(std::move(buffer));
  require_no_error("reading back", size);
  return pending;
}

Layout layout_of(PendingRead::What what) {
  if (what == PendingRead::What::color) return {GL_COLOR_ATTACHMENT0, GL_RGBA, GL_FLOAT, sizeof(glm::vec4)};
  return {GL_COLOR_ATTACHMENT1, GL_RGBA_INTEGER, GL_UNSIGNED_INT, sizeof(glm::uvec4)};
}

}  // namespace

PendingRead::PendingRead(const RenderTarget& target, What what)
    : size_(target.size()), buffer_(copied(target.framebuffer(), size_, layout_of(what))) {}

PendingRead::PendingRead(const DisplayTexture& shown)
    : size_(shown.size()),
      buffer_(copied(shown.framebuffer(), size_,
                     {GL_COLOR_ATTACHMENT0, GL_RGBA, GL_UNSIGNED_BYTE, sizeof(glm::u8vec4)})) {}

}  // namespace crest::gl
