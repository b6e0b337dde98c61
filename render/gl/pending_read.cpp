#include "render/gl/pending_read.h"

#include "render/gl/errors.h"

namespace crest::gl {

// glReadPixels into a buffer waits on no driver of a graphics card; of glGetTextureSubImage some are not so
// sure.
PendingRead::PendingRead(const RenderTarget& target, What what) : size_(target.size()) {
  const bool color = what == What::color;
  forget_errors();
  GLuint id = 0;
  glCreateBuffers(1, &id);
  buffer_ = BufferHandle(id);
  glNamedBufferStorage(id, GLsizeiptr(size_.x) * size_.y * GLsizeiptr(sizeof(glm::vec4)), nullptr, 0);
  glNamedFramebufferReadBuffer(target.framebuffer(), color ? GL_COLOR_ATTACHMENT0 : GL_COLOR_ATTACHMENT1);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, target.framebuffer());
  glBindBuffer(GL_PIXEL_PACK_BUFFER, id);
  glReadPixels(0, 0, size_.x, size_.y, color ? GL_RGBA : GL_RGBA_INTEGER, color ? GL_FLOAT : GL_UNSIGNED_INT,
               nullptr);
  glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
  copied_.reset(glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0));
  glFlush();  // or the fence might never be reached
  require_no_error("reading back", size_);
}

bool PendingRead::is_over() const {
  const GLenum state = glClientWaitSync(copied_.get(), 0, 0);
  return state != GL_TIMEOUT_EXPIRED;  // also where the driver failed: reading tells
}

void PendingRead::copy_to(void* pixels, std::size_t bytes) const {
  forget_errors();
  glGetNamedBufferSubData(buffer_.id(), 0, GLsizeiptr(bytes), pixels);
  require_no_error("reading back", size_);
}

}  // namespace crest::gl
