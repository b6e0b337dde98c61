#include "render/renderer.h"

#include "render/gl/errors.h"
#include "render/resources/classification.h"
#include "render/resources/volume_texture.h"

namespace crest {
namespace {

/// Otherwise the ray caster draws, also where the exact answer is named, which is no engine of the GPU.
bool is_drawn_by_vdls(const Scene& scene) {
  switch (scene.rendering.engine) {
    case Engine::vdls:
      return true;
    case Engine::raycaster:
    case Engine::reference:
      break;
  }
  return false;
}

}  // namespace

Renderer::Renderer(std::filesystem::path shader_folder, std::filesystem::path program_folder)
    : resources_(std::make_shared<Resources>(std::move(shader_folder), std::move(program_folder))),
      raycaster_(resources_),
      vdls_(resources_) {}

void Renderer::draw(const Scene& scene, const Camera& camera, gl::RenderTarget& target, Tile tile) {
  draw(scene, camera, target, tile, nullptr);
}

void Renderer::draw(const Scene& scene, const Camera& camera, gl::RenderTarget& target) {
  draw(scene, camera, target, Tile{{0, 0}, target.size()});
}

std::optional<gl::PendingBuffer> Renderer::begin(const Scene& scene, const Camera& camera,
                                                 gl::RenderTarget& target, Tile tile) {
  if (!is_drawn_by_vdls(scene)) return std::nullopt;
  gl::forget_errors();
  std::optional<gl::PendingBuffer> begun = vdls_.begin(scene, camera, target, tile);
  gl::require_no_error("drawing", target.size());
  return begun;
}

void Renderer::draw(const Scene& scene, const Camera& camera, gl::RenderTarget& target, Tile tile,
                    const gl::PendingBuffer* begun) {
  gl::forget_errors();
  if (!is_drawn_by_vdls(scene))
    raycaster_.draw(scene, camera, target, tile);
  else if (begun)
    vdls_.draw(scene, camera, target, tile, *begun);
  else
    vdls_.draw(scene, camera, target, tile);
  gl::require_no_error("drawing", target.size());
}

void Renderer::draw_at_once(const Scene& scene, const Camera& camera, gl::RenderTarget& target) {
  if (!is_drawn_by_vdls(scene)) return draw(scene, camera, target);
  gl::forget_errors();
  vdls_.draw_at_once(scene, camera, target);
  gl::require_no_error("drawing", target.size());
}

std::vector<PixelCounts> Renderer::draw_counts(const Scene& scene, const Camera& camera,
                                               gl::RenderTarget& target) {
  if (!is_drawn_by_vdls(scene)) return raycaster_.draw_counts(scene, camera, target);
  draw(scene, camera, target);
  std::vector<PixelCounts> pixels;
  add_counts(pixels, target.read_counts(), CountsOf::layers, true);
  return pixels;
}

PendingCounts Renderer::begin_counts(const Scene& scene, const Camera& camera, gl::RenderTarget& target) {
  if (!is_drawn_by_vdls(scene)) return raycaster_.begin_counts(scene, camera, target);
  draw_at_once(scene, camera, target);
  PendingCounts pending{CountsOf::layers, {}};
  pending.passes.emplace_back(target, gl::PendingRead::What::counts);
  return pending;
}

PictureNeed Renderer::need(const Scene& scene, const Camera& camera, glm::ivec2 size) {
  if (is_drawn_by_vdls(scene)) return vdls_.need(scene, size);
  const Need need = raycaster_.need(scene, camera, size, false);
  PictureNeed result{need.list, gpu_data(need, *scene.volume, classification(scene)), {}};
  if (need.features.dvr && !need.features.preintegrated && !need.features.analytic)
    result.tf_error = need.tf_table.error;
  return result;
}

const Classification& Renderer::classification(const Scene& scene) {
  resources_->held.begin_round();
  return classification_of(resources_->held, scene);
}

void Renderer::hold(const std::shared_ptr<const Volume>& volume) {
  resources_->held.begin_round();
  hold_volume(*resources_, volume);
}

void Renderer::clear() {
  resources_->programs.clear();
  resources_->held.clear();
}

}  // namespace crest
