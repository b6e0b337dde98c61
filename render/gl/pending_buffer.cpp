#include "render/gl/pending_buffer.h"

#include "render/gl/errors.h"

namespace crest::gl {

PendingBuffer::PendingBuffer(BufferHandle buffer)
    : buffer_(std::move(buffer)), written_(glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0)) {
  glFlush();  // or the fence might never be reached
}

bool PendingBuffer::is_over() const { return glClientWaitSync(written_.get(), 0, 0) != GL_TIMEOUT_EXPIRED; }

void PendingBuffer::copy_to(void* data, std::size_t bytes) const {
  forget_errors();
  glGetNamedBufferSubData(buffer_.id(), 0, GLsizeiptr(bytes), data);
  require_no_error("reading back");
}

}  // namespace crest::gl
