#pragma once

#include <optional>

#include "presets/choices.h"
#include "render/raycaster/raycaster.h"
#include "render/scene/picture_need.h"
#include "render/vdls/vdls.h"

namespace crest {

/// Draws a scene with the engine that its settings name; both hold one copy of what they share. The exact
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
  /// Raycaster::draw waits for nothing, and Vdls::draw for the layers of the tile. To wait for neither, begin
  /// with what has to be known of the tile, if anything (Vdls::begin), and draw it when that is over.
  std::optional<gl::PendingBuffer> begin(const Scene& scene, const Camera& camera, gl::RenderTarget& target,
                                         Tile tile);
  void draw(const Scene& scene, const Camera& camera, gl::RenderTarget& target, Tile tile,
            const gl::PendingBuffer* begun);
  /// The same of a small picture: without waiting, through more layers than there may be.
  void draw_at_once(const Scene& scene, const Camera& camera, gl::RenderTarget& target);
  /// The whole picture, with the costs of each pixel. `target` has counts.
  std::vector<PixelCounts> draw_counts(const Scene& scene, const Camera& camera, gl::RenderTarget& target);

  /// The same of a small picture, without waiting for the device.
  PendingCounts begin_counts(const Scene& scene, const Camera& camera, gl::RenderTarget& target);

  /// What a picture of this size is made from.
  PictureNeed need(const Scene& scene, const Camera& camera, glm::ivec2 size);
  /// What the TF brings in this scene; it stays valid until the next draw or call with another scene.
  const Classification& classification(const Scene& scene);
  /// Uploads the volume. Throws Error where the driver cannot hold it.
  void hold(const std::shared_ptr<const Volume>& volume);
  /// Lets go of all that it holds for pictures to come.
  void clear();

  Resources& resources() { return *resources_; }
  Raycaster& raycaster() { return raycaster_; }
  Vdls& vdls() { return vdls_; }

 private:
  std::shared_ptr<Resources> resources_;
  Raycaster raycaster_;
  Vdls vdls_;
};

}  // namespace crest
