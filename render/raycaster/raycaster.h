#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "render/gl/render_target.h"
#include "render/picture_cost.h"
#include "render/raycaster/need.h"
#include "render/scene.h"

namespace crest {

/// The single-pass ray caster. It keeps what the last scenes needed (the volume's texture, the TF's tables,
/// the shader variants) and rebuilds only what changed. A GL 4.5 context must be current throughout.
class Raycaster {
 public:
  /// Shaders are read from `shader_folder`, or, when it is empty, from the program itself. Linked programs
  /// are kept in `program_folder` for the next start, unless it is empty.
  explicit Raycaster(std::filesystem::path shader_folder = {}, std::filesystem::path program_folder = {});
  ~Raycaster();
  Raycaster(Raycaster&&) noexcept;

  /// Draws a tile of the picture that `camera` sees. With a target that has counts, they are counted. Throws
  /// Error for a volume that the driver cannot hold, or a shader that does not compile and has no last good
  /// one.
  void draw(const Scene& scene, const Camera& camera, gl::RenderTarget& target, Tile tile);

  /// The same for the whole picture.
  void draw(const Scene& scene, const Camera& camera, gl::RenderTarget& target);

  /// The whole picture, with the costs of each pixel counted over all passes. `target` has counts.
  std::vector<PixelCounts> draw_counts(const Scene& scene, const Camera& camera, gl::RenderTarget& target);

  /// The same, summed over all pixels.
  RenderCounts draw_counted(const Scene& scene, const Camera& camera, gl::RenderTarget& target);

  /// What the TF brings in this scene; it stays valid until the next draw or call with another scene.
  const Classification& classification(const Scene& scene);
  /// What a picture of this size is made from.
  Need need(const Scene& scene, const Camera& camera, glm::ivec2 size, bool statistics);
  /// Its features, where the whole volume is in view.
  Features features(const Scene& scene, bool statistics);

  /// From now on: for tests and measurements.
  void force(const Forced& forced);

  /// Compiles every variant again when it is next needed. Where that fails, the last good one is kept, and
  /// shader_error says why.
  void reload_shaders();
  const std::string& shader_error() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace crest
