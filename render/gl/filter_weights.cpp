#include "render/gl/filter_weights.h"

#include <algorithm>
#include <cmath>

#include "render/gl/fullscreen.h"
#include "render/gl/program.h"
#include "render/gl/render_target.h"
#include "render/gl/texture.h"

namespace crest::gl {

double measure_weight_error(GLenum format) {
  constexpr glm::ivec2 size{4096, 1};
  constexpr double rounding = 0x1p-16;  // of places in the texture; weights of 15 bits would be as good
  const float values[8] = {0, 1, 0, 1, 0, 1, 0, 1};
  const TextureHandle ramp = make_texture(GL_TEXTURE_3D, GL_LINEAR);
  glTextureStorage3D(ramp.id(), 1, format, 2, 2, 2);
  glTextureSubImage3D(ramp.id(), 0, 0, 0, 0, 2, 2, 2, GL_RED, GL_FLOAT, values);  // converted to the format
  const ProgramHandle program = build_fullscreen_program("filter_weights.frag", {});
  const RenderTarget target(size, false);
  begin_whole_target(target.framebuffer(), size);
  glBindTextureUnit(0, ramp.id());
  glProgramUniform1i(program.id(), glGetUniformLocation(program.id(), "ramp"), 0);
  glProgramUniform1f(program.id(), glGetUniformLocation(program.id(), "places"), float(size.x));
  FullscreenTriangle().draw(program.id());
  double error = 0;
  for (const glm::vec4& pixel : target.read_color().pixels)
    error = std::max(error, std::abs(double(pixel.x)));
  return error > rounding ? error : 0;
}

int weight_bits(double weight_error) { return int(std::lround(-std::log2(2 * weight_error))); }

}  // namespace crest::gl
