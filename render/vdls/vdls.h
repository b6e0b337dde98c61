#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "render/gl/render_target.h"
#include "render/picture_cost.h"
#include "render/picture_need.h"
#include "render/scene.h"
#include "render/vdls/quadtree.h"

namespace crest {

/// What the last picture, or tile of one, took.
struct VdlsWork {
  int layers = 0, passes = 0;
  std::vector<ScreenNode> nodes;  ///< of the quadtree
  double drawn_samples = 0;  ///< by all pixels of the nodes, also those that were already out of the volume
};

/// The engine of view-dependent layer sampling: instead of ray by ray it renders the samples of all rays
/// layer by layer, a pass of the graphics pipeline for some layers at a time, as rendering.vdls says.
/// Samples, TF and shading are the ray caster's in DVR_ONLY, so that both give the same picture to float
/// rounding. It keeps what the last scene needed and rebuilds only what changed. A GL 4.5 context must be
/// current throughout.
class Vdls {
 public:
  /// Shaders are read from `shader_folder`, or, when it is empty, from the program itself. Linked programs
  /// are kept in `program_folder` for the next start, unless it is empty.
  explicit Vdls(std::filesystem::path shader_folder = {}, std::filesystem::path program_folder = {});
  ~Vdls();
  Vdls(Vdls&&) noexcept;

  /// Draws a tile of the picture that `camera` sees. With a target that has counts, they are counted; all
  /// samples are DVR's. Throws Error for a scene that VDLS does not render (why_not_vdls), a volume that the
  /// driver cannot hold, or a shader that does not compile and has no last good one.
  void draw(const Scene& scene, const Camera& camera, gl::RenderTarget& target, Tile tile);

  /// What a picture of this size is made from.
  PictureNeed need(const Scene& scene, glm::ivec2 size);
  const VdlsWork& last_work() const;

  void reload_shaders();
  const std::string& shader_error() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Why VDLS does not render a scene, as a sentence; empty where it does.
std::string why_not_vdls(const Scene& scene);

}  // namespace crest
