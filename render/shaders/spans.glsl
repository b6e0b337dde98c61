// A part of a ray without a gap, from where it enters to where it exits: the box, what empty cells leave of it, or what
// lies in macrocells of one kind.

#include "ray.glsl"

struct Span {
  float enter, exit;
};
