#pragma once

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <memory>
#include <type_traits>
#include <vector>

#include "render/gl/handle.h"
#include "render/gl/render_target.h"

namespace crest::gl {

/// A picture on its way into memory, that nobody waits for: what was drawn until now is copied into a buffer
/// on the device, which is read once that is over.
class PendingRead {
 public:
  enum class What { color, counts };
  /// The target may be drawn into again, or die, at once. Throws Error when the driver has no room.
  PendingRead(const RenderTarget& target, What what);

  bool is_over() const;  ///< does not wait
  /// glm::vec4 of a colour, glm::uvec4 of counts. Waits until it is over. Throws Error when the driver fails.
  std::vector<glm::vec4> color() const { return pixels<glm::vec4>(); }
  std::vector<glm::uvec4> counts() const { return pixels<glm::uvec4>(); }

 private:
  struct DeleteSync {
    void operator()(GLsync sync) const { glDeleteSync(sync); }
  };
  template <class Pixel>
  std::vector<Pixel> pixels() const {
    std::vector<Pixel> all(std::size_t(size_.x) * std::size_t(size_.y));
    copy_to(all.data(), all.size() * sizeof(Pixel));
    return all;
  }
  void copy_to(void* pixels, std::size_t bytes) const;

  glm::ivec2 size_;
  BufferHandle buffer_;
  std::unique_ptr<std::remove_pointer_t<GLsync>, DeleteSync> copied_;
};

}  // namespace crest::gl
