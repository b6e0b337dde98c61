#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace crest {

/// The plane through the volume on which the coordinate of an axis has a value; it spans the volume's box.
struct Slice {
  int axis = 2;      ///< 0, 1, 2: the plane is across x, y, z
  double place = 0;  ///< in [0, 1], from the box's first point to its last
  bool operator==(const Slice&) const = default;
};

/// The axes that go right and up in a slice's picture: (y, z), (x, z), (x, y).
glm::ivec2 slice_axes(int axis);

/// The place in the box, each axis from 0 to 1, of a place in the picture, from its top left corner, in [0,
/// 1].
glm::dvec3 place_in_box(const Slice& slice, glm::dvec2 in_picture);

}  // namespace crest
