#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>

#include "render/gl/fullscreen.h"
#include "render/gl/handle.h"
#include "render/gl/render_target.h"

namespace crest::gl {

/// An opaque 8-bit picture to be shown on the screen, row 0 at the top.
class DisplayTexture {
 public:
  explicit DisplayTexture(glm::ivec2 size);
  glm::ivec2 size() const { return size_; }
  GLuint texture() const { return texture_.id(); }
  GLuint framebuffer() const { return framebuffer_.id(); }
  /// Shows the same as `small`, enlarged smoothly.
  void enlarge(const DisplayTexture& small);

 private:
  glm::ivec2 size_;
  TextureHandle texture_;
  FramebufferHandle framebuffer_;
};

/// Puts pictures over a background into display textures.
class Presenter {
 public:
  Presenter();

  /// The rows [first_row, last_row) of `to`, from the same part of `from`; a smaller picture is enlarged
  /// smoothly.
  void present(const RenderTarget& from, DisplayTexture& to, glm::vec3 background, int first_row,
               int last_row);
  /// The same of how far each pixel may be off (PixelCounts::error_bound): `from` has counts, and the size of
  /// `to`.
  void present_error_bounds(const RenderTarget& from, DisplayTexture& to, int first_row, int last_row);
  /// How much `b` differs from `a`, each over its background: of each channel amplified, from black on; or
  /// with its sign, about grey. All have one size.
  struct Side {
    const RenderTarget& picture;
    glm::vec3 background;
  };
  void present_difference(Side a, Side b, DisplayTexture& to, double amplification, bool with_sign);
  /// The same as numbers: a pixel of the target is a block of difference_block^2 pixels, (the greatest
  /// difference of a channel, the sum of all squares, how many pixels are off by more than `least`, 1).
  RenderTarget sum_difference(Side a, Side b, double least);
  static constexpr int difference_block = 16;

 private:
  void draw(GLuint program, DisplayTexture& to, int first_row, int last_row);
  static void set_sides(GLuint program, const Side& a, const Side& b);

  ProgramHandle program_;
  std::optional<ProgramHandle> error_program_, difference_program_, sum_program_;  ///< once they were needed
  FullscreenTriangle triangle_;
};

}  // namespace crest::gl
