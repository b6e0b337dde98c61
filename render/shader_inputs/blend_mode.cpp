#include "render/shader_inputs/blend_mode.h"

#include "render/classify/tf_table.h"
#include "render/gl/uniforms.h"

namespace crest {

double iso_opacity(const TransferFunction& tf, ValueRange field) { return 0.5 * largest_opacity(tf, field); }

void bind_blend_mode(GLuint program, const Scene& scene, const StoredUnits& units) {
  const ValueRange field = scene.volume->statistics.range;
  const double spacing = scene.volume->grid.smallest_spacing(), width = units.stored(field).width();
  gl::set(program, "value_min_scale", glm::vec2(units.stored(field.min), width > 0 ? 1 / width : 0));
  gl::set(program, "iso_extinction",
          float(extinction(iso_opacity(scene.tf, field), scene.tf.unit_distance) * spacing));
  gl::set(program, "sample_thickness", float(scene.tf.unit_distance / spacing));
}

void set_blending(BlendMode blend_mode, bool back_to_front) {
  glBlendEquation(GL_FUNC_ADD);
  switch (blend_mode) {
    case BlendMode::maximum:
      return glBlendEquation(GL_MAX);
    case BlendMode::minimum:
      return glBlendEquation(GL_MIN);
    case BlendMode::mean:
      return glBlendFunc(GL_ONE, GL_ONE);
    case BlendMode::semi_transparent:
    case BlendMode::lookup:
    case BlendMode::iso_surface:
      break;
  }
  if (back_to_front)
    glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  else
    glBlendFunc(GL_ONE_MINUS_DST_ALPHA, GL_ONE);
}

}  // namespace crest
