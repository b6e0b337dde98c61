#pragma once

#include <epoxy/gl.h>

#include <functional>
#include <map>
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

/// Counts the calls of this thread that wait until the graphics device is through with something, as long as
/// it lives: pictures and textures that are read at once, buffers and times that are read before they are
/// there.
class GlWaits {
 public:
  int count() const { return count_; }

 private:
  template <auto& pointer>
  using Watch = Watched<pointer, std::remove_reference_t<decltype(pointer)>>;

  void note_fence() {  // of what was asked for last
    if (written_) is_known_[std::exchange(written_, 0)] = true;
  }
  int count_ = 0;
  GLuint written_ = 0;
  std::map<GLuint, bool> is_known_;
};

}  // namespace crest::testing
