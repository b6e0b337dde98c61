#include "render/renderer.h"

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

Renderer::Renderer(std::filesystem::path shader_folder)
    : shader_folder_(std::move(shader_folder)), raycaster_(shader_folder_) {}

Vdls& Renderer::vdls() { return vdls_ ? *vdls_ : vdls_.emplace(shader_folder_); }

void Renderer::draw(const Scene& scene, const Camera& camera, gl::RenderTarget& target, Tile tile) {
  if (is_drawn_by_vdls(scene))
    vdls().draw(scene, camera, target, tile);
  else
    raycaster_.draw(scene, camera, target, tile);
}

void Renderer::draw(const Scene& scene, const Camera& camera, gl::RenderTarget& target) {
  draw(scene, camera, target, Tile{{0, 0}, target.size()});
}

std::vector<PixelCounts> Renderer::draw_counts(const Scene& scene, const Camera& camera,
                                               gl::RenderTarget& target) {
  if (!is_drawn_by_vdls(scene)) return raycaster_.draw_counts(scene, camera, target);
  draw(scene, camera, target);
  std::vector<PixelCounts> pixels;
  for (const glm::uvec4 counts : target.read_counts())
    pixels.push_back({counts.x, counts.y, 0, 0, bool(counts.w >> 31)});
  return pixels;
}

PictureNeed Renderer::need(const Scene& scene, const Camera& camera, glm::ivec2 size) {
  if (is_drawn_by_vdls(scene)) return vdls().need(scene, size);
  const Need need = raycaster_.need(scene, camera, size, false);
  PictureNeed result{need.list, gpu_data(need, *scene.volume, raycaster_.classification(scene)), {}};
  if (need.features.dvr && !need.features.preintegrated) result.tf_error = need.tf_table.error;
  return result;
}

void Renderer::reload_shaders() {
  raycaster_.reload_shaders();
  if (vdls_) vdls_->reload_shaders();
}

const std::string& Renderer::shader_error() const {
  const std::string& error = raycaster_.shader_error();
  return error.empty() && vdls_ ? vdls_->shader_error() : error;
}

}  // namespace crest
