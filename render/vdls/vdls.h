#pragma once

#include <memory>
#include <string>
#include <vector>

#include "render/gl/pending_buffer.h"
#include "render/gl/render_target.h"
#include "render/resources/resources.h"
#include "render/scene/picture_cost.h"
#include "render/scene/picture_need.h"
#include "render/scene/scene.h"
#include "render/vdls/layer_textures.h"
#include "render/vdls/proxy.h"
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
/// rounding. A GL 4.5 context must be current throughout.
class Vdls {
 public:
  /// With all that it makes kept in `resources`.
  explicit Vdls(std::shared_ptr<Resources> resources);

  /// Draws a tile of the picture that `camera` sees. With a target that has counts, they are counted; all
  /// samples are DVR's. Throws Error for a scene that VDLS does not render (why_not_vdls), a volume that the
  /// driver cannot hold, or a shader that does not compile and has no last good one.
  void draw(const Scene& scene, const Camera& camera, gl::RenderTarget& target, Tile tile);

  /// draw() waits until the device has told how many layers the leaves of the tile have. To go on meanwhile:
  /// begin, and draw what was begun when it is over. Both throw as draw().
  gl::PendingBuffer begin(const Scene& scene, const Camera& camera, gl::RenderTarget& target, Tile tile);
  void draw(const Scene& scene, const Camera& camera, gl::RenderTarget& target, Tile tile,
            const gl::PendingBuffer& begun);
  /// A small picture without waiting: each leaf goes through as many layers as the longest ray could have.
  /// Throws Error also where that is more than 8192.
  void draw_at_once(const Scene& scene, const Camera& camera, gl::RenderTarget& target);

  /// What a picture of this size is made from.
  PictureNeed need(const Scene& scene, glm::ivec2 size);
  const VdlsWork& last_work() const { return work_; }

 private:
  struct Prepared;
  Prepared prepare(const Scene& scene);
  Prepared hold(const Scene& scene);  ///< and its volume is on the device
  Box visible_part(const Prepared& p);
  Box shown_part(const Prepared& p);  ///< of that, what the clip box leaves
  /// Each leaf's greatest sample count.
  using LeafCounts = std::vector<std::uint32_t>;
  void draw_into(const gl::RenderTarget& target, Tile tile);
  /// Begins the picture; the leaves' counts go into a buffer of zeros, or of the same.
  void set_up(const Prepared& p, const Camera& camera, const gl::RenderTarget& target, Tile tile,
              GLuint counts);
  void finish(const Prepared& p, const Camera& camera, const gl::RenderTarget& target,
              const LeafCounts& counts);
  Proxy make_proxy(const Prepared& p, const Camera& camera, glm::ivec2 size, const LeafCounts& counts);
  void bind_volume(const Prepared& p, GLuint program);
  void draw_layers(const Prepared& p, const Camera& camera, glm::ivec2 size, const Proxy& proxy);

  std::shared_ptr<Resources> resources_;
  gl::VertexArrayHandle vertex_array_;
  LayerTextures layers_;
  GLuint set_up_ = 0;  ///< the buffer of the picture that layers_ holds the beginning of; 0 = of none
  VdlsWork work_;
};

/// Why VDLS does not render a scene, as a sentence; empty where it does.
std::string why_not_vdls(const Scene& scene);

}  // namespace crest
