#include "render/gl/fullscreen.h"

namespace crest::gl {

FullscreenTriangle::FullscreenTriangle() {
  GLuint id = 0;
  glCreateVertexArrays(1, &id);
  vertex_array_ = VertexArrayHandle(id);
}

void FullscreenTriangle::draw(GLuint program) const {
  glUseProgram(program);
  glBindVertexArray(vertex_array_.id());
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

void begin_whole_target(GLuint framebuffer, glm::ivec2 size) {
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  glViewport(0, 0, size.x, size.y);
  glDisable(GL_SCISSOR_TEST);
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_CULL_FACE);
  glDisable(GL_BLEND);
}

}  // namespace crest::gl
