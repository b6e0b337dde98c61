#pragma once

#include <epoxy/gl.h>

#include <functional>
#include <map>
#include <type_traits>
#include <utility>

namespace crest::testing {

/// A GL function that is called through libepoxy's pointer, with something done before each call as long as
/// this lives. One at a time of each function.
template <auto& pointer, class Function>
class Watched;
template <auto& pointer, class Result, class... Arguments>
class Watched<pointer, Result (*)(Arguments...)> {
 public:
  using Before = std::function<void(Arguments...)>;
  explicit Watched(Before before) : before_(std::move(before)) {
    real_ = std::exchange(pointer, call);
    watching_ = this;
  }
  ~Watched() { pointer = real_; }
  Watched(const Watched&) = delete;
  Watched& operator=(const Watched&) = delete;

 private:
  /// libepoxy may put the driver's function into its pointer at the first call.
  struct Unwatched {
    Unwatched() { pointer = real_; }
    ~Unwatched() { real_ = std::exchange(pointer, call); }
  };
  static Result call(Arguments... arguments) {
    const Unwatched unwatched;
    watching_->before_(arguments...);
    return real_(arguments...);
  }
  static inline Result (*real_)(Arguments...) = nullptr;
  static inline Watched* watching_ = nullptr;
  Before before_;
};

/// Counts the calls that wait until the graphics device is through with something, as long as it lives:
/// pictures that are read at once, buffers and times that are read before they are there.
class GlWaits {
 public:
  int count() const { return count_; }

 private:
  template <auto& pointer>
  using Watch = Watched<pointer, std::remove_reference_t<decltype(pointer)>>;

  void read_buffer(GLuint id) {
    const auto written = fences_.find(id);
    const bool is_there =
        written != fences_.end() && glClientWaitSync(written->second, 0, 0) != GL_TIMEOUT_EXPIRED;
    if (!is_there) ++count_;
  }
  void read_pixels() {
    GLint buffer = 0;
    glGetIntegerv(GL_PIXEL_PACK_BUFFER_BINDING, &buffer);
    written_ = GLuint(buffer);
    if (buffer == 0) ++count_;
  }
  void read_query(GLuint id, GLenum what) {
    GLint is_there = GL_FALSE;
    glGetQueryObjectiv(id, GL_QUERY_RESULT_AVAILABLE, &is_there);
    if (what == GL_QUERY_RESULT && !is_there) ++count_;
  }
  /// A fence is about the buffer that was written last; one of our own beside it tells as much.
  void make_fence() {
    if (written_) fences_[written_] = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
  }

  int count_ = 0;
  GLuint written_ = 0;
  std::map<GLuint, GLsync> fences_;
  Watch<epoxy_glReadPixels> pixels_{[this](auto...) { read_pixels(); }};
  Watch<epoxy_glGetTextureImage> image_{[this](auto...) { ++count_; }};
  Watch<epoxy_glGetTextureSubImage> part_{[this](auto...) { ++count_; }};
  Watch<epoxy_glGetTexImage> bound_image_{[this](auto...) { ++count_; }};
  Watch<epoxy_glMapNamedBuffer> map_{[this](auto...) { ++count_; }};
  Watch<epoxy_glMapNamedBufferRange> map_range_{[this](auto...) { ++count_; }};
  Watch<epoxy_glFinish> finish_{[this] { ++count_; }};
  Watch<epoxy_glGetNamedBufferSubData> buffer_{[this](GLuint id, auto...) { read_buffer(id); }};
  Watch<epoxy_glGetQueryObjectui64v> time_{[this](GLuint id, GLenum what, auto) { read_query(id, what); }};
  Watch<epoxy_glFenceSync> fence_{[this](auto...) { make_fence(); }};
  Watch<epoxy_glBindBufferBase> storage_{[this](GLenum, GLuint, GLuint id) { written_ = id; }};
};

}  // namespace crest::testing
