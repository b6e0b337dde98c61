#pragma once

#include <cmath>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "render/gl/handle.h"
#include "render/gl/render_target.h"
#include "render/raycaster/drawn_parts.h"
#include "render/raycaster/need.h"
#include "render/raycaster/pending_counts.h"
#include "render/resources/resources.h"
#include "render/scene/picture_cost.h"
#include "render/scene/scene.h"

namespace crest {

/// The single-pass ray caster: it decides what a picture needs, binds that, and draws. A GL 4.5 context must
/// be current throughout.
class Raycaster {
 public:
  /// With all that it makes kept in `resources`.
  explicit Raycaster(std::shared_ptr<Resources> resources);
  /// With resources of its own. Shaders are read from `shader_folder`, or, when it is empty, from the program
  /// itself.
  explicit Raycaster(std::filesystem::path shader_folder = {});

  /// Draws a tile of the picture that `camera` sees. With a target that has counts, they are counted. Throws
  /// Error for a volume that the driver cannot hold, or a shader that does not compile and has no last good
  /// one.
  void draw(const Scene& scene, const Camera& camera, gl::RenderTarget& target, Tile tile);

  /// The same for the whole picture.
  void draw(const Scene& scene, const Camera& camera, gl::RenderTarget& target);

  /// The whole picture, with the costs of each pixel counted over all passes. `target` has counts.
  std::vector<PixelCounts> draw_counts(const Scene& scene, const Camera& camera, gl::RenderTarget& target);

  /// The same without waiting for the device: each pass is held on it until it is read.
  PendingCounts begin_counts(const Scene& scene, const Camera& camera, gl::RenderTarget& target);

  /// As draw_counts, summed over all pixels.
  RenderCounts draw_counted(const Scene& scene, const Camera& camera, gl::RenderTarget& target);

  /// What a picture of this size is made from.
  Need need(const Scene& scene, const Camera& camera, glm::ivec2 size, bool statistics);
  /// Its features, where the whole volume is in view.
  Features features(const Scene& scene, bool statistics);

  /// From now on: for tests and measurements.
  void force(const Forced& forced);
  /// From now on, for tests: as if the texture unit's weights had so many bits.
  void assume_weight_bits(int bits) { resources_->weight_error = std::ldexp(0.5, -bits); }

  Resources& resources() { return *resources_; }

 private:
  Need find_need(const Scene& scene, const Camera& camera, glm::ivec2 size, bool statistics);
  void draw(const Scene& scene, const Camera& camera, gl::RenderTarget& target, Tile tile, const Need& needs,
            const std::function<void(int pass)>& after_pass);
  std::vector<Tile> drawn_parts(const Scene& scene, const Camera& camera, const gl::RenderTarget& target,
                                Tile tile, const Need& needs);
  void draw_passes(const Scene& scene, const Camera& camera, const gl::RenderTarget& target, Tile tile,
                   const Need& needs, const std::function<void(int pass)>& after_pass);

  std::shared_ptr<Resources> resources_;
  gl::VertexArrayHandle vertex_array_;
  Forced forced_;
  PictureParts parts_;
};

}  // namespace crest
