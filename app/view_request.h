#pragma once

#include <glm/vec2.hpp>

#include "render/scene/camera.h"
#include "render/scene/scene.h"

namespace crest {

/// What a view is to show.
struct ViewRequest {
  Scene scene;
  Camera camera;
  glm::ivec2 size{0};        ///< (0, 0): the view is not visible
  bool error_bound = false;  ///< of an exact scene: how far each pixel may be off, in place of the picture
  bool operator==(const ViewRequest& other) const;
};

bool is_same_but_for_bound(ViewRequest a, const ViewRequest& b);

/// Whether a pixel of the one may take far longer than one of the other: not so while a camera or a point of
/// the TF is dragged, or time steps are played.
bool may_cost_other(const ViewRequest& a, const ViewRequest& b);

}  // namespace crest
