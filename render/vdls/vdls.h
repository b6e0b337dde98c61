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

/// How VDLS goes about its work. None of it changes the picture by more than float rounding, but for the
/// quantised gradients.
struct VdlsOptions {
  bool homo_regions = true;  ///< leap over what the TF makes transparent (section 4.1)
  int leaves = 32;  ///< the screen quadtree begins with leaves x leaves squares (4.2): a power of two;
                    ///< 0 = no quadtree, the projected box is drawn
  int merge_threshold = 8;  ///< brothers whose sample counts differ by no more become one node
  bool early_test = true;   ///< rays that are out of the volume are left alone (4.3)
  int layers_per_pass = 8;  ///< samples that a pass takes of each ray (4.3), at least 1; the paper's card: 2
  bool back_to_front = false;
  bool gradient_volume = true;  ///< shading takes precomputed gradients (3.3); else those of the ray caster

  /// VDLS without its speed-ups, one layer a pass.
  static VdlsOptions basic() { return {false, 0, 0, false, 1, false, true}; }
};

/// What the last picture, or tile of one, took.
struct VdlsWork {
  int layers = 0, passes = 0;
  std::vector<ScreenNode> nodes;  ///< of the quadtree
  double drawn_samples = 0;  ///< by all pixels of the nodes, also those that were already out of the volume
};

/// The engine of view-dependent layer sampling: instead of ray by ray it renders the samples of all rays
/// layer by layer, a pass of the graphics pipeline for some layers at a time. Samples, TF and shading are the
/// ray caster's in DVR_ONLY, so that both give the same picture to float rounding. It keeps what the last
/// scene needed and rebuilds only what changed. A GL 4.5 context must be current throughout.
class Vdls {
 public:
  /// Shaders are read from `shader_folder`, or, when it is empty, from the program itself.
  explicit Vdls(std::filesystem::path shader_folder = {});
  ~Vdls();
  Vdls(Vdls&&) noexcept;

  void set_options(const VdlsOptions& options);

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
