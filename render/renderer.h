#pragma once

#include <optional>

#include "render/raycaster/raycaster.h"
#include "render/vdls/vdls.h"

namespace crest {

/// The settings in another mode, with the ray caster where their own engine does not render it.
inline Rendering in_mode(Rendering rendering, Mode mode) {
  rendering.mode = mode;
  if (rendering.engine == Engine::vdls && mode != Mode::dvr_only) rendering.engine = Engine::raycaster;
  return rendering;
}

/// Draws a scene with the engine that its settings name. VDLS comes to be when it is first chosen; the exact
/// answer is not an engine of the GPU: where it is named, the ray caster draws. A GL 4.5 context must be
/// current throughout.
class Renderer {
 public:
  /// Shaders are read from `shader_folder`, or, when it is empty, from the program itself. Linked programs
  /// are kept in `program_folder` for the next start, unless it is empty.
  explicit Renderer(std::filesystem::path shader_folder = {}, std::filesystem::path program_folder = {});

  /// As Raycaster::draw and Vdls::draw.
  void draw(const Scene& scene, const Camera& camera, gl::RenderTarget& target, Tile tile);
  void draw(const Scene& scene, const Camera& camera, gl::RenderTarget& target);
  /// The whole picture, with the costs of each pixel. `target` has counts.
  std::vector<PixelCounts> draw_counts(const Scene& scene, const Camera& camera, gl::RenderTarget& target);

  /// What a picture of this size is made from.
  PictureNeed need(const Scene& scene, const Camera& camera, glm::ivec2 size);
  /// What the TF brings in this scene; it stays valid until the next draw or call with another scene.
  const Classification& classification(const Scene& scene) { return raycaster_.classification(scene); }

  Raycaster& raycaster() { return raycaster_; }
  Vdls& vdls();

  /// Compiles every variant again when it is next needed. Where that fails, the last good one is kept, and
  /// shader_error says why.
  void reload_shaders();
  const std::string& shader_error() const;

 private:
  std::filesystem::path shader_folder_, program_folder_;
  Raycaster raycaster_;
  std::optional<Vdls> vdls_;
};

}  // namespace crest
