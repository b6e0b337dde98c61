#pragma once

#include <array>
#include <memory>
#include <optional>

#include "render/slices/slice_renderer.h"
#include "ui/studio.h"

namespace crest {

/// The pictures of the slices that the window shows, drawn anew where something changed. A GL 4.5 context
/// must be current throughout.
class SlicePictures {
 public:
  /// Throws Error where the driver has no room.
  void update(Resources& resources, const Scene& scene, const SlicesWanted& wanted);
  std::array<std::uintptr_t, slice_count> textures() const;  ///< 0 while there is none
  /// Lets go of the volume; the textures stay, since the frame that is being drawn may name them.
  void forget() {
    for (Picture& picture : pictures_) picture.scene.reset();
  }
  /// Lets go of all, where no frame names them.
  void clear() { pictures_ = {}; }

 private:
  struct Picture {
    std::optional<Scene> scene;  ///< of what is drawn
    Slice slice;
    std::unique_ptr<gl::DisplayTexture> display;
    std::unique_ptr<gl::DisplayTexture> last;  ///< of another size: the frame that is being drawn names it
  };
  void draw(Resources& resources, const Scene& scene, Picture& picture, const Slice& slice, glm::ivec2 size);

  std::optional<SliceRenderer> renderer_;
  std::array<Picture, slice_count> pictures_;
};

}  // namespace crest
