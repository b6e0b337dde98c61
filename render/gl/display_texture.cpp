#include "render/gl/display_texture.h"

#include "render/gl/program.h"
#include "render/gl/texture.h"

namespace crest::gl {

DisplayTexture::DisplayTexture(glm::ivec2 size) : size_(size) {
  texture_ = make_texture(GL_TEXTURE_2D, GL_LINEAR);
  glTextureStorage2D(texture_.id(), 1, GL_RGBA8, size.x, size.y);
  GLuint framebuffer = 0;
  glCreateFramebuffers(1, &framebuffer);
  framebuffer_ = FramebufferHandle(framebuffer);
  glNamedFramebufferTexture(framebuffer, GL_COLOR_ATTACHMENT0, texture_.id(), 0);
}

Presenter::Presenter() : program_(build_fullscreen_program("present.frag", {})) {
  GLuint id = 0;
  glCreateVertexArrays(1, &id);
  vertex_array_ = VertexArrayHandle(id);
}

void Presenter::present(const RenderTarget& from, DisplayTexture& to, glm::vec3 background, int first_row,
                        int last_row) {
  const GLuint program = program_.id();
  glBindTextureUnit(0, from.color_texture());
  glProgramUniform1i(program, glGetUniformLocation(program, "picture"), 0);
  glProgramUniform3f(program, glGetUniformLocation(program, "background"), background.x, background.y,
                     background.z);
  glProgramUniform2f(program, glGetUniformLocation(program, "scale"),
                     float(from.size().x) / float(to.size().x), float(from.size().y) / float(to.size().y));
  glBindFramebuffer(GL_FRAMEBUFFER, to.framebuffer());
  glViewport(0, 0, to.size().x, to.size().y);
  glScissor(0, first_row, to.size().x, last_row - first_row);
  glEnable(GL_SCISSOR_TEST);
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_BLEND);
  glUseProgram(program);
  glBindVertexArray(vertex_array_.id());
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glDisable(GL_SCISSOR_TEST);
}

}  // namespace crest::gl
