#include "render/gl/display_texture.h"

#include <fmt/core.h>

#include "render/gl/program.h"
#include "render/gl/texture.h"
#include "render/scene/error_colors.h"

namespace crest::gl {

DisplayTexture::DisplayTexture(glm::ivec2 size) : size_(size) {
  texture_ = make_texture(GL_TEXTURE_2D, GL_LINEAR);
  glTextureStorage2D(texture_.id(), 1, GL_RGBA8, size.x, size.y);
  GLuint framebuffer = 0;
  glCreateFramebuffers(1, &framebuffer);
  framebuffer_ = FramebufferHandle(framebuffer);
  glNamedFramebufferTexture(framebuffer, GL_COLOR_ATTACHMENT0, texture_.id(), 0);
}

void DisplayTexture::enlarge(const DisplayTexture& small) {
  glDisable(GL_SCISSOR_TEST);
  glBlitNamedFramebuffer(small.framebuffer(), framebuffer(), 0, 0, small.size().x, small.size().y, 0, 0,
                         size_.x, size_.y, GL_COLOR_BUFFER_BIT, GL_LINEAR);
}

Presenter::Presenter() : program_(build_fullscreen_program("present.frag", {})) {}

void Presenter::present(const RenderTarget& from, DisplayTexture& to, glm::vec3 background, int first_row,
                        int last_row) {
  const GLuint program = program_.id();
  glBindTextureUnit(0, from.color_texture());
  glProgramUniform1i(program, glGetUniformLocation(program, "picture"), 0);
  glProgramUniform3f(program, glGetUniformLocation(program, "background"), background.x, background.y,
                     background.z);
  glProgramUniform2f(program, glGetUniformLocation(program, "scale"),
                     float(from.size().x) / float(to.size().x), float(from.size().y) / float(to.size().y));
  draw(program, to, first_row, last_row);
}

void Presenter::present_error_bounds(const RenderTarget& from, DisplayTexture& to, int first_row,
                                     int last_row) {
  const auto colors = error_scale();
  if (!error_program_)
    error_program_ =
        build_fullscreen_program("present_error.frag", {fmt::format("ERROR_COLORS {}", colors.size())});
  const GLuint program = error_program_->id();
  glBindTextureUnit(0, from.counts_texture());
  glProgramUniform1i(program, glGetUniformLocation(program, "counts"), 0);
  glProgramUniform3fv(program, glGetUniformLocation(program, "error_scale"), GLsizei(colors.size()),
                      &colors.front().x);
  glProgramUniform2f(program, glGetUniformLocation(program, "shown_errors"), float(least_shown_error),
                     float(most_shown_error));
  draw(program, to, first_row, last_row);
}

void Presenter::set_sides(GLuint program, const Side& a, const Side& b) {
  const auto place = [&](const char* name) { return glGetUniformLocation(program, name); };
  glBindTextureUnit(0, a.picture.color_texture());
  glBindTextureUnit(1, b.picture.color_texture());
  glProgramUniform1i(program, place("picture_a"), 0);
  glProgramUniform1i(program, place("picture_b"), 1);
  glProgramUniform3fv(program, place("background_a"), 1, &a.background.x);
  glProgramUniform3fv(program, place("background_b"), 1, &b.background.x);
}

void Presenter::present_difference(Side a, Side b, DisplayTexture& to, double amplification, bool with_sign) {
  if (!difference_program_) difference_program_ = build_fullscreen_program("present_difference.frag", {});
  const GLuint program = difference_program_->id();
  set_sides(program, a, b);
  glProgramUniform1f(program, glGetUniformLocation(program, "amplification"), float(amplification));
  glProgramUniform1i(program, glGetUniformLocation(program, "with_sign"), with_sign);
  draw(program, to, 0, to.size().y);
}

RenderTarget Presenter::sum_difference(Side a, Side b, double least) {
  if (!sum_program_)
    sum_program_ =
        build_fullscreen_program("sum_difference.frag", {fmt::format("BLOCK {}", difference_block)});
  const GLuint program = sum_program_->id();
  set_sides(program, a, b);
  glProgramUniform1f(program, glGetUniformLocation(program, "least"), float(least));
  RenderTarget sums((a.picture.size() + difference_block - 1) / difference_block, false);
  begin_whole_target(sums.framebuffer(), sums.size());
  triangle_.draw(program);
  return sums;
}

void Presenter::draw(GLuint program, DisplayTexture& to, int first_row, int last_row) {
  begin_whole_target(to.framebuffer(), to.size());
  glScissor(0, first_row, to.size().x, last_row - first_row);
  glEnable(GL_SCISSOR_TEST);
  triangle_.draw(program);
  glDisable(GL_SCISSOR_TEST);
}

}  // namespace crest::gl
