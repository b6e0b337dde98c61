#include "render/slices/slice_renderer.h"

#include "render/classify/stored_units.h"
#include "render/gl/uniforms.h"
#include "render/raycaster/bindings.h"
#include "render/resources/classification.h"
#include "render/resources/shader_tf_texture.h"
#include "render/resources/table_textures.h"
#include "render/resources/volume_texture.h"
#include "render/scene/camera.h"
#include "render/shader_inputs/view_uniforms.h"
#include "render/volume/whole_values.h"

namespace crest {
namespace {

using gl::set;

constexpr float line_pixels = 1.5F;
enum Unit : GLuint { volume_unit, brick_table_unit, empty_cells_unit, tf_unit };

Features features_of(Resources& resources, const Scene& scene) {
  // The texture unit's filter may have 8 bits: lines would be stairs
  const auto exact = [](Filter filter) { return filter == Filter::linear ? Filter::linear_exact : filter; };
  Features features;
  features.filter = exact(dvr_filter(scene.rendering).kind);
  features.root_filter = exact(root_filter(scene.rendering).kind);
  features.own_root_filter = features.filter != features.root_filter;
  features.empty_cells = scene.volume->has_empty_cells();
  features.bricks = is_in_bricks(resources, scene.volume);
  features.whole_values = whole_values(*scene.volume).has_value();
  return features;
}

/// Those that a slice goes through, with what its filters reach.
std::shared_ptr<const BrickSet> bricks_of(const Grid& grid, const Slice& slice) {
  constexpr int reach = 3;
  glm::ivec3 from(0), to = grid.dims - 1;
  const int at = int(slice.place * to[slice.axis]);
  from[slice.axis] = at - reach;
  to[slice.axis] = at + 1 + reach;
  BrickSet bricks(brick_count(grid));
  add_bricks(bricks, grid, from, to);
  return std::make_shared<const BrickSet>(std::move(bricks));
}

void bind(Resources& resources, GLuint program, const Scene& scene, const Slice& slice,
          const Features& features) {
  KeyedCache& held = resources.held;
  const Volume& volume = *scene.volume;
  const StoredUnits units = stored_units(volume);
  const ValueRange range = with_width(units.stored(volume.statistics.range));
  const Classification& classification = classification_of(held, scene);
  const std::vector<Peak> surfaces = units.stored(classification.surfaces);
  const auto bind_texture = [&](Unit unit, const char* sampler, GLuint texture) {
    glBindTextureUnit(unit, texture);
    set(program, sampler, int(unit));
  };
  bind_volume(resources, scene.volume, features.bricks ? bricks_of(volume.grid, slice) : nullptr,
              {volume_unit, brick_table_unit}, program);
  if (features.empty_cells)
    bind_texture(empty_cells_unit, "empty_cells",
                 empty_cells_texture(held, scene.volume, support_radius(scene.rendering)));
  if (uses_filter(features, Filter::bc)) set_bc_weights(program, scene.rendering);
  const ShaderTfTexture& pieces =
      shader_tf_texture(held, units.stored(classification.tf), {}, range, volume.grid.smallest_spacing());
  bind_texture(tf_unit, "tf_pieces", pieces.texture.id());
  set(program, "tf_piece_count", pieces.count);
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, peak_buffer(held, surfaces));
  set(program, "surface_count", int(surfaces.size()));
  set(program, "line_width", line_pixels);
  set(program, "grey_min_scale", glm::vec2(range.min, 1 / range.width()));
}

/// Row 0 is at the top, and what goes up in the picture grows.
void place(GLuint program, const Grid& grid, const Slice& slice, glm::ivec2 size) {
  const glm::dvec3 box = grid.box_size() / grid.smallest_spacing();
  const auto position = [&](double x, double y) { return place_in_box(slice, {x, y}) * box; };
  const glm::dvec3 corner = position(0, 0);
  set(program, "slice_corner", glm::vec3(corner));
  set(program, "slice_right", glm::vec3((position(1, 0) - corner) / double(size.x)));
  set(program, "slice_down", glm::vec3((position(0, 1) - corner) / double(size.y)));
}

}  // namespace

void SliceRenderer::draw(Resources& resources, const Scene& scene, const Slice& slice,
                         gl::DisplayTexture& to) {
  resources.held.begin_round();
  const Features features = features_of(resources, scene);
  const GLuint program =
      resources.programs.program("fullscreen.vert", "slice.frag", shader_defines(features));
  bind(resources, program, scene, slice, features);
  set_view(program, scene, whole_volume_camera(scene.volume->grid, 1), to.size());
  place(program, scene.volume->grid, slice, to.size());
  gl::begin_whole_target(to.framebuffer(), to.size());
  triangle_.draw(program);
}

}  // namespace crest
