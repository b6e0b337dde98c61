#pragma once

#include <cstdint>
#include <glm/gtc/type_precision.hpp>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <vector>

#include "render/gl/display_texture.h"
#include "render/gl/pending_buffer.h"
#include "render/gl/render_target.h"

namespace crest::gl {

/// A picture on its way into memory, that nobody waits for: what was drawn until now is copied into a buffer
/// on the device, which is read once that is over.
class PendingRead {
 public:
  enum class What { color, counts };
  /// The target may be drawn into again, or die, at once. Throws Error when the driver has no room.
  PendingRead(const RenderTarget& target, What what);
  /// The same of what is shown.
  explicit PendingRead(const DisplayTexture& shown);

  glm::ivec2 size() const { return size_; }
  bool is_over() const { return buffer_.is_over(); }  ///< does not wait
  /// glm::vec4 of a colour, glm::uvec4 of counts, four bytes a pixel of what is shown; row 0 at the top.
  /// Waits until it is over. Throws Error when the driver fails.
  std::vector<glm::vec4> color() const { return pixels<glm::vec4>(); }
  std::vector<glm::uvec4> counts() const { return pixels<glm::uvec4>(); }
  std::vector<glm::u8vec4> shown() const { return pixels<glm::u8vec4>(); }

 private:
  template <class Pixel>
  std::vector<Pixel> pixels() const {
    std::vector<Pixel> all(std::size_t(size_.x) * std::size_t(size_.y));
    buffer_.copy_to(all.data(), all.size() * sizeof(Pixel));
    return all;
  }

  glm::ivec2 size_;
  PendingBuffer buffer_;
};

}  // namespace crest::gl
