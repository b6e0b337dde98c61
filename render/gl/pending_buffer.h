#pragma once

#include <cstddef>
#include <memory>
#include <type_traits>

#include "render/gl/handle.h"

namespace crest::gl {

/// Bytes that the device is still writing, and that nobody waits for.
class PendingBuffer {
 public:
  /// `buffer`, which what was asked of the device until now writes.
  explicit PendingBuffer(BufferHandle buffer);

  GLuint id() const { return buffer_.id(); }
  bool is_over() const;  ///< does not wait; true also where the driver failed, which reading tells
  /// The first `bytes`. Waits until it is over. Throws Error when the driver fails.
  void copy_to(void* data, std::size_t bytes) const;

 private:
  struct DeleteSync {
    void operator()(GLsync sync) const { glDeleteSync(sync); }
  };
  BufferHandle buffer_;
  std::unique_ptr<std::remove_pointer_t<GLsync>, DeleteSync> written_;
};

}  // namespace crest::gl
