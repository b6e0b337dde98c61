#include "render/slices/slice.h"

namespace crest {

glm::ivec2 slice_axes(int axis) { return axis == 0 ? glm::ivec2(1, 2) : glm::ivec2(0, axis == 1 ? 2 : 1); }

glm::dvec3 place_in_box(const Slice& slice, glm::dvec2 in_picture) {
  const glm::ivec2 axes = slice_axes(slice.axis);
  glm::dvec3 place;
  place[slice.axis] = slice.place;
  place[axes.x] = in_picture.x;
  place[axes.y] = 1 - in_picture.y;
  return place;
}

}  // namespace crest
