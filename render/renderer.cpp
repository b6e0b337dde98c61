#include "render/renderer.h"

#include "render/gl/errors.h"

namespace crest {

Renderer::Renderer(std::filesystem::path shader_folder, std::filesystem::path program_folder)
    : shader_folder_(std::move(shader_folder)),
      program_folder_(std::move(program_folder)),
      raycaster_(shader_folder_, program_folder_) {}

Vdls& Renderer::vdls() { return vdls_ ? *vdls_ : vdls_.emplace(shader_folder_, program_folder_); }

void Renderer::draw(const Scene& scene, const Camera& camera, gl::RenderTarget& target, Tile tile) {
  gl::forget_errors();
  if (scene.rendering.engine == Engine::vdls)
    vdls().draw(scene, camera, target, tile);
  else
    raycaster_.draw(scene, camera, target, tile);
  gl::require_no_error("drawing", target.size());
}

void Renderer::draw(const Scene& scene, const Camera& camera, gl::RenderTarget& target) {
  draw(scene, camera, target, Tile{{0, 0}, target.size()});
}

std::vector<PixelCounts> Renderer::draw_counts(const Scene& scene, const Camera& camera,
                                               gl::RenderTarget& target) {
  if (scene.rendering.engine != Engine::vdls) return raycaster_.draw_counts(scene, camera, target);
  draw(scene, camera, target);
  std::vector<PixelCounts> pixels;
  for (const glm::uvec4 counts : target.read_counts())
    pixels.push_back({counts.x, counts.y, 0, 0, bool(counts.w >> 31)});
  return pixels;
}

PictureNeed Renderer::need(const Scene& scene, const Camera& camera, glm::ivec2 size) {
  if (scene.rendering.engine == Engine::vdls) return vdls().need(scene, size);
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
