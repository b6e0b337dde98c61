#pragma once

#include "render/gl/display_texture.h"
#include "render/resources/resources.h"
#include "render/scene/scene.h"
#include "render/slices/slice.h"

namespace crest {

/// Draws slices (shaders/slice.frag): the TF's colours over a grey of the value, and the lines in which the
/// surfaces meet the slice, of the scene's filters; clip box, mode and light have no part in it. A line is as
/// far from a pixel as the values differ, by the field's change from pixel to pixel: exact where the field is
/// linear, and to first order elsewhere. A GL 4.5 context must be current throughout.
class SliceRenderer {
 public:
  /// Fills `to`. Throws Error.
  void draw(Resources& resources, const Scene& scene, const Slice& slice, gl::DisplayTexture& to);

 private:
  gl::FullscreenTriangle triangle_;
};

}  // namespace crest
