#pragma once

#include <epoxy/gl.h>

#include <glm/vec2.hpp>

#include "render/gl/handle.h"

namespace crest::gl {

/// What a program with fullscreen.vert draws: one triangle over a whole target, without any attribute.
class FullscreenTriangle {
 public:
  FullscreenTriangle();
  void draw(GLuint program) const;

 private:
  VertexArrayHandle vertex_array_;
};

/// Draws go into all of this framebuffer, as they are: no scissor, depth, culling or blending.
void begin_whole_target(GLuint framebuffer, glm::ivec2 size);

}  // namespace crest::gl
