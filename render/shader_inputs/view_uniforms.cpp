#include "render/shader_inputs/view_uniforms.h"

#include "render/gl/uniforms.h"
#include "render/scene/camera.h"
#include "render/volume/clip.h"

namespace crest {

using gl::set;

void set_view(GLuint program, const Scene& scene, const Camera& camera, glm::ivec2 size) {
  const Grid& grid = scene.volume->grid;
  const double unit = grid.smallest_spacing();
  const RayFrame rays = ray_frame(camera, grid, size);
  const glm::dvec3 cell_size = grid.spacing / unit;
  set(program, "image_size", glm::vec2(size));
  set(program, "box_size", glm::vec3(grid.box_size() / unit));
  const Box rendered = rendered_box(grid, scene.rendering.clip_box);
  set(program, "rendered_min", glm::vec3((rendered.min - grid.origin) / unit));
  set(program, "rendered_max", glm::vec3((rendered.max - grid.origin) / unit));
  set(program, "cell_size", glm::vec3(cell_size));
  set(program, "texture_scale", glm::vec3(1.0 / (cell_size * glm::dvec3(grid.dims))));
  set(program, "texture_offset", glm::vec3(0.5 / glm::dvec3(grid.dims)));
  set(program, "ray_anchor", glm::vec3(rays.anchor));
  set(program, "ray_anchor_u", glm::vec3(rays.anchor_u));
  set(program, "ray_anchor_v", glm::vec3(rays.anchor_v));
  set(program, "ray_w", glm::vec3(rays.w));
  set(program, "ray_u", glm::vec3(rays.u));
  set(program, "ray_v", glm::vec3(rays.v));
  set(program, "eye_to_anchor", float(rays.eye_to_anchor));
  set(program, "step_length", float(scene.rendering.step));
  set(program, "pixel_diagonal", float(rays.pixel));
  set(program, "s_k", float(scene.rendering.s_k));
}

}  // namespace crest
