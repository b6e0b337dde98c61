#include "app/view_request.h"

namespace crest {

bool ViewRequest::operator==(const ViewRequest& other) const {
  return scene.volume == other.scene.volume && scene.tf == other.scene.tf &&
         scene.rendering == other.scene.rendering && camera == other.camera && size == other.size &&
         error_bound == other.error_bound;
}

bool is_same_but_for_bound(ViewRequest a, const ViewRequest& b) {
  a.error_bound = b.error_bound;
  return a == b;
}

bool may_cost_other(const ViewRequest& a, const ViewRequest& b) {
  const bool have_volumes = a.scene.volume && b.scene.volume;
  return !(a.scene.rendering == b.scene.rendering) || !have_volumes ||
         a.scene.volume->grid.dims != b.scene.volume->grid.dims;
}

}  // namespace crest
