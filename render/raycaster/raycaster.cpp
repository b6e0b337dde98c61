#include "render/raycaster/raycaster.h"

#include <algorithm>

#include "presets/choices.h"
#include "render/gl/draw_state.h"
#include "render/gl/filter_weights.h"
#include "render/gl/uniforms.h"
#include "render/raycaster/bindings.h"
#include "render/raycaster/drawn_parts.h"
#include "render/resources/classification.h"
#include "render/resources/macrocell_texture.h"
#include "render/resources/texel_format.h"
#include "render/resources/volume_texture.h"
#include "render/scene/camera.h"
#include "render/shader_inputs/blend_mode.h"
#include "render/shader_inputs/view_uniforms.h"
#include "render/volume/clip.h"

namespace crest {
namespace {

using gl::set;

void clear(const gl::RenderTarget& target) {
  constexpr GLfloat transparent[4] = {};
  constexpr GLuint none[4] = {};
  glClearNamedFramebufferfv(target.framebuffer(), GL_COLOR, 0, transparent);
  if (target.has_counts()) glClearNamedFramebufferuiv(target.framebuffer(), GL_COLOR, 1, none);
}

gl::VertexArrayHandle make_vertex_array() {
  GLuint id = 0;
  glCreateVertexArrays(1, &id);
  return gl::VertexArrayHandle(id);
}

/// Where nothing is drawn, nothing is off.
CountsOf what_is_counted(const Scene& scene, const Need& needs) {
  const Features& drawn = needs.features;
  const bool exact =
      drawn.analytic || (is_analytic(scene.rendering.classification) && !drawn.dvr && !drawn.peaks);
  return exact ? CountsOf::exact_march : CountsOf::samples;
}

}  // namespace

Raycaster::Raycaster(std::shared_ptr<Resources> resources)
    : resources_(std::move(resources)), vertex_array_(make_vertex_array()) {}

Raycaster::Raycaster(std::filesystem::path shader_folder)
    : Raycaster(std::make_shared<Resources>(std::move(shader_folder))) {}

Need Raycaster::need(const Scene& scene, const Camera& camera, glm::ivec2 size, bool statistics) {
  resources_->held.begin_round();
  return find_need(scene, camera, size, statistics);
}

Need Raycaster::find_need(const Scene& scene, const Camera& camera, glm::ivec2 size, bool statistics) {
  KeyedCache& held = resources_->held;
  const Classification& classification = classification_of(held, scene);
  const auto share = [&](const Features& features, const TableBlur& blur) {
    return occupied_share(held, {scene, classification, features, blur});
  };
  const auto weight_error = [&] {
    if (!resources_->weight_error) resources_->weight_error = gl::measure_weight_error();
    return *resources_->weight_error;
  };
  Need need = crest::find_need(*scene.volume, classification, scene.rendering, camera, size, statistics,
                               forced_, share, weight_error, is_in_bricks(*resources_, scene.volume));
  need.texel_bytes = texel_kind(held, *scene.volume).bytes;
  if (need.features.bricks)
    need.brick_count =
        size_of(*shown_bricks(held, {scene, classification, need.needed, need.tf_blur}, need.longest_step));
  return need;
}

Features Raycaster::features(const Scene& scene, bool statistics) {
  return need(scene, whole_volume_camera(scene.volume->grid, 1), {1, 1}, statistics).features;
}

void Raycaster::draw(const Scene& scene, const Camera& camera, gl::RenderTarget& target, Tile tile,
                     const Need& needs, const std::function<void(int pass)>& after_pass) {
  if (!needs.is_empty()) hold_volume(*resources_, scene.volume);  // which may draw
  glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer());
  glViewport(0, 0, target.size().x, target.size().y);
  glScissor(tile.begin.x, tile.begin.y, tile.end.x - tile.begin.x, tile.end.y - tile.begin.y);
  const gl::DrawState state;
  clear(target);
  if (needs.is_empty()) {
    if (after_pass) after_pass(0);
  } else {
    draw_passes(scene, camera, target, tile, needs, after_pass);
  }
}

// Where nothing can be met nothing is drawn, but where costs are counted.
std::vector<Tile> Raycaster::drawn_parts(const Scene& scene, const Camera& camera,
                                         const gl::RenderTarget& target, Tile tile, const Need& needs) {
  if (target.has_counts()) return {tile};
  const Box box = rendered_box(scene.volume->grid, scene.rendering.clip_box);
  const ShownParts shown{scene, classification_of(resources_->held, scene), needs.needed, needs.tf_blur};
  if (needs.needed.skipping)
    return parts_.that_meet(shown_boxes(resources_->held, shown), box, camera, target.size(), tile);
  return parts_.that_meet(divided(box), box, camera, target.size(), tile);
}

void Raycaster::draw_passes(const Scene& scene, const Camera& camera, const gl::RenderTarget& target,
                            Tile tile, const Need& needs, const std::function<void(int pass)>& after_pass) {
  const GLuint id = resources_->programs.program("fullscreen.vert", fragment_shader(needs.features),
                                                 shader_defines(needs.features));
  bind_scene(*resources_, scene, classification_of(resources_->held, scene), needs, id);
  set_view(id, scene, camera, target.size());
  set_blending(needs.features.blend_mode, false);
  glBindVertexArray(vertex_array_.id());
  glUseProgram(id);
  const std::vector<Tile> parts = drawn_parts(scene, camera, target, tile, needs);
  for (int pass = 0; pass < needs.passes(); ++pass) {
    set(id, "first_interval", pass * needs.intervals_per_pass);
    set(id, "interval_count", needs.intervals_per_pass);
    if (pass == 1) glEnablei(GL_BLEND, 0);
    for (const Tile& part : parts) {
      glScissor(part.begin.x, part.begin.y, part.end.x - part.begin.x, part.end.y - part.begin.y);
      glDrawArrays(GL_TRIANGLES, 0, 3);
    }
    if (after_pass) after_pass(pass);
  }
}

void Raycaster::draw(const Scene& scene, const Camera& camera, gl::RenderTarget& target, Tile tile) {
  draw(scene, camera, target, tile, need(scene, camera, target.size(), target.has_counts()), {});
}

void Raycaster::draw(const Scene& scene, const Camera& camera, gl::RenderTarget& target) {
  draw(scene, camera, target, Tile{{0, 0}, target.size()});
}

std::vector<PixelCounts> Raycaster::draw_counts(const Scene& scene, const Camera& camera,
                                                gl::RenderTarget& target) {
  const Need needs = need(scene, camera, target.size(), target.has_counts());
  std::vector<PixelCounts> sums;
  draw(scene, camera, target, Tile{{0, 0}, target.size()}, needs,
       [&](int pass) { add_counts(sums, target.read_counts(), what_is_counted(scene, needs), pass == 0); });
  return sums;
}

PendingCounts Raycaster::begin_counts(const Scene& scene, const Camera& camera, gl::RenderTarget& target) {
  const Need needs = need(scene, camera, target.size(), target.has_counts());
  PendingCounts pending{what_is_counted(scene, needs), {}};
  draw(scene, camera, target, Tile{{0, 0}, target.size()}, needs,
       [&](int) { pending.passes.emplace_back(target, gl::PendingRead::What::counts); });
  return pending;
}

RenderCounts Raycaster::draw_counted(const Scene& scene, const Camera& camera, gl::RenderTarget& target) {
  return sum_of(draw_counts(scene, camera, target));
}

void Raycaster::force(const Forced& forced) { forced_ = forced; }

}  // namespace crest
