// A stretch of a ray.

#include "ray.glsl"

struct Span {
  float enter, exit;
};
