#pragma once

#include <epoxy/gl.h>

namespace crest::gl {

/// Drawing within a scissor, without depth test and culling, and at first without blending. Scissor and
/// blending are off in the end, also where something is thrown.
class DrawState {
 public:
  DrawState() {
    glEnable(GL_SCISSOR_TEST);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_CULL_FACE);
    glDisable(GL_BLEND);
  }
  ~DrawState() {
    glDisable(GL_SCISSOR_TEST);
    glDisable(GL_BLEND);
  }
  DrawState(const DrawState&) = delete;
  DrawState& operator=(const DrawState&) = delete;
};

}  // namespace crest::gl
