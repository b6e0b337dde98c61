#pragma once

#include <cstddef>
#include <glm/vec2.hpp>

#include "render/files/image.h"
#include "render/gl/handle.h"

namespace crest::gl {

/// Throws Error when a picture's size is not in 1..16384.
void require_size(glm::ivec2 size);

/// A picture is read back in parts of at most so many bytes: GL counts them in 31 bits.
inline constexpr std::size_t largest_read = std::size_t(256) << 20;

/// What is drawn into: premultiplied RGBA in 32-bit float, row 0 at the top; with `counts`, also four
/// counters a pixel, as unsigned integers.
class RenderTarget {
 public:
  /// Throws Error as require_size(), or when the driver has no room for it.
  RenderTarget(glm::ivec2 size, bool counts);

  glm::ivec2 size() const { return size_; }
  bool has_counts() const { return bool(counts_); }
  GLuint framebuffer() const { return framebuffer_.id(); }
  GLuint color_texture() const { return color_.id(); }
  GLuint counts_texture() const { return counts_.id(); }  ///< 0 without counts

  /// Both throw Error when the driver fails.
  Image read_color(std::size_t part_bytes = largest_read) const;
  std::vector<glm::uvec4> read_counts(std::size_t part_bytes = largest_read) const;

 private:
  glm::ivec2 size_;
  TextureHandle color_, counts_;
  FramebufferHandle framebuffer_;
};

}  // namespace crest::gl
