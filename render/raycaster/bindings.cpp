#include "render/raycaster/bindings.h"

#include <glm/mat4x4.hpp>
#include <limits>

#include "render/classify/stored_units.h"
#include "render/gl/uniforms.h"
#include "render/resources/macrocell_texture.h"
#include "render/resources/preintegration_textures.h"
#include "render/resources/shader_tf_texture.h"
#include "render/resources/table_textures.h"
#include "render/resources/volume_texture.h"
#include "render/shader_inputs/blend_mode.h"

namespace crest {
namespace {

using gl::set;

enum Unit : GLuint {
  volume_unit,
  brick_table_unit,
  empty_cells_unit,
  macrocells_unit,
  tf_unit,  ///< or what stands for the TF: antiderivatives, pre-integration table
  peak_table_unit
};

/// What is bound, and to which program.
struct Binding {
  KeyedCache& held;
  const Scene& scene;
  const Classification& classification;
  const Need& need;
  GLuint program;
  StoredUnits units;  ///< of the volume's texture, and so of every value that a shader is given
  double spacing;     ///< the smallest
};

void bind_texture(const Binding& b, Unit unit, const char* sampler, GLuint texture) {
  glBindTextureUnit(unit, texture);
  set(b.program, sampler, int(unit));
}

void bind_macrocells(const Binding& b) {
  Features features = b.need.needed;  // what is forced in does not show
  features.skipping = b.need.features.skipping;
  bind_texture(b, macrocells_unit, "macrocells",
               macrocell_texture(b.held, {b.scene, b.classification, features, b.need.tf_blur}));
  const Volume& volume = *b.scene.volume;
  set(b.program, "macrocell_size",
      glm::vec3(volume.grid.spacing / b.spacing * double(macrocell_side(volume))));
}

void bind_antiderivatives(const Binding& b, const TransferFunction& tf, ValueRange field) {
  const int bins = b.need.tf_table.entries - 1;
  const auto& table = antiderivatives_texture(b.held, tf, field, b.spacing, bins);
  bind_texture(b, tf_unit, "antiderivatives", table.texture.id());
  set(b.program, "antiderivatives_min_scale", glm::vec2(table.range.min, bins / table.range.width()));
}

void bind_preintegration(const Binding& b, const TransferFunction& tf, ValueRange field) {
  const int bins = b.need.preintegration_bins;
  const double step = b.scene.rendering.step;
  const auto& table = preintegration_texture(b.held, tf, field, b.spacing, step, bins);
  bind_texture(b, tf_unit, "preintegration_table", table.texture.id());
  // The centres of the first and the last texel are the range's ends
  const double scale = (bins - 1.0) / bins / table.range.width();
  set(b.program, "preintegration_min_scale_offset", glm::vec3(table.range.min, scale, 0.5 / bins));
  set(b.program, "preintegrated_length", float(step));
}

/// What DVR looks up; where DVR is only forced in, a TF that shows nothing.
void bind_tf(const Binding& b) {
  TransferFunction shown;
  if (b.need.needed.dvr)
    shown = b.units.stored(b.need.features.base_tf ? b.classification.base : b.classification.tf);
  const ValueRange field = b.units.stored(dvr_range(b.scene));
  if (b.need.features.preintegration_table) return bind_preintegration(b, shown, field);
  if (b.need.features.preintegrated) return bind_antiderivatives(b, shown, field);
  bind_tf_texture(b.program, tf_texture(b.held, shown, field, b.spacing, b.need.tf_table.entries), tf_unit);
}

void set_few_peaks(GLuint program, const std::vector<Peak>& peaks) {
  glm::vec4 values(std::numeric_limits<float>::infinity());
  for (std::size_t i = 0; i < peaks.size(); ++i) values[int(i)] = float(peaks[i].value);
  glProgramUniform4f(program, glGetUniformLocation(program, "few_peaks"), values.x, values.y, values.z,
                     values.w);
  set(program, "peak_count", int(peaks.size()));
}

/// Where peaks are only forced in, none is met.
void bind_peaks(const Binding& b) {
  std::vector<Peak> surfaces;
  if (b.need.needed.peaks) surfaces = b.units.stored(b.classification.surfaces);
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, peak_buffer(b.held, surfaces));
  if (!b.need.features.peak_table) return set_few_peaks(b.program, surfaces);

  const ValueRange field = b.units.stored(surface_range(b.scene));
  const auto& table = peak_table_texture(b.held, surfaces, field, b.need.peak_bins);
  bind_texture(b, peak_table_unit, "peak_table", table.texture.id());
  set(b.program, "bin_min_scale", glm::vec2(table.range.min, table.bin_scale));
}

/// What is only forced in does not show.
void bind_tf_pieces(const Binding& b) {
  TransferFunction tf;
  std::vector<Peak> surfaces;
  if (b.need.needed.dvr)
    tf = b.units.stored(b.need.features.base_tf ? b.classification.base : b.classification.tf);
  if (b.need.needed.peaks) surfaces = b.units.stored(b.classification.surfaces);
  const ShaderTfTexture& pieces =
      shader_tf_texture(b.held, tf, surfaces, b.units.stored(b.scene.volume->statistics.range), b.spacing);
  bind_texture(b, tf_unit, "tf_pieces", pieces.texture.id());
  set(b.program, "tf_piece_count", pieces.count);
  set(b.program, "extinction_scale", pieces.extinction_scale);
  const glm::dvec3 steps = b.scene.volume->statistics.largest_difference;
  set(b.program, "neighbour_range", float(b.units.scale * (steps.x + steps.y + steps.z)));
  if (b.need.features.peaks) glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, peak_buffer(b.held, surfaces));
}

}  // namespace

void set_bc_weights(GLuint program, const Rendering& rendering) {
  const auto weights = filter_weights({Filter::bc, rendering.bc_b, rendering.bc_c});
  glm::mat4 by_power;  // column k: what multiplies u^k
  for (int k = 0; k < 4; ++k)
    for (int i = 0; i < 4; ++i) by_power[k][i] = float(weights[std::size_t(i)][std::size_t(k)]);
  glProgramUniformMatrix4fv(program, glGetUniformLocation(program, "bc_weights"), 1, GL_FALSE,
                            &by_power[0][0]);
}

void bind_scene(Resources& resources, const Scene& scene, const Classification& classification,
                const Need& need, GLuint program) {
  KeyedCache& held = resources.held;
  const Features& features = need.features;
  const Volume& volume = *scene.volume;
  const Binding b{
      held, scene, classification, need, program, stored_units(volume), volume.grid.smallest_spacing()};
  std::shared_ptr<const BrickSet> bricks;
  if (features.bricks)
    bricks = shown_bricks(held, {scene, classification, need.needed, need.tf_blur}, need.longest_step);
  bind_volume(resources, scene.volume, bricks, {volume_unit, brick_table_unit}, program);
  if (features.empty_cells)
    bind_texture(b, empty_cells_unit, "empty_cells",
                 empty_cells_texture(held, scene.volume, support_radius(scene.rendering)));
  if (uses_filter(features, Filter::bc)) set_bc_weights(program, scene.rendering);
  if (features.skipping || features.adaptive) bind_macrocells(b);
  if (features.analytic) bind_tf_pieces(b);
  if (features.dvr && !features.analytic) bind_tf(b);
  if (features.blend_mode != BlendMode::semi_transparent) bind_blend_mode(program, scene, b.units);
  if (features.peaks && !features.analytic) bind_peaks(b);
  // What is forced in does not show
  set(program, "max_peaks", scene.rendering.max_peaks);
  set(program, "least_residual",
      need.needed.early_termination ? float(scene.rendering.early_termination) : 0.0f);
  set(program, "shading_strength", need.needed.shading ? 1.0f : 0.0f);
}

}  // namespace crest
