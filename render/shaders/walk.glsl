// A walk along a ray from cell to cell of a grid (Amanatides and Woo 1987). Where the ray meets a face follows from the
// face's index each time: a sum of distances from face to face would drift by more than positions are rounded.

#include "spans.glsl"

struct Walk {
  ivec3 cells;  // of the grid
  ivec3 cell, step;
  vec3 origin, inverse, size;  // of the ray; of its direction; of a cell
  vec3 next;                   // where the ray meets the next face of each axis
  float t, end;
};

// Where the ray meets the faces ahead of the cell.
vec3 faces_ahead(Walk walk) {
  vec3 faces = vec3(walk.cell + max(walk.step, ivec3(0)));
  return (faces * walk.size - walk.origin) * walk.inverse;
}

Walk begin_walk(Ray ray, Span span, ivec3 cells, vec3 size) {
  Walk walk;
  walk.cells = cells;
  walk.cell = clamp(ivec3(floor(at(ray, span.enter) / size)), ivec3(0), cells - 1);
  walk.step = mix(ivec3(-1), ivec3(1), greaterThan(ray.direction, vec3(0.0)));
  walk.origin = ray.origin;
  walk.inverse = 1.0 / ray.direction;
  walk.size = size;
  bvec3 is_parallel = lessThan(abs(ray.direction), vec3(1.0e-30));
  walk.next = mix(faces_ahead(walk), vec3(3.0e38), is_parallel);
  walk.t = span.enter;
  walk.end = span.exit;
  return walk;
}

// To the next cell; false at the end of the ray. (Masks in place of an index: drivers put vectors that are indexed by a
// variable into memory.)
bool advance(inout Walk walk) {
  float nearest = min(walk.next.x, min(walk.next.y, walk.next.z));
  bool x = walk.next.x == nearest, y = !x && walk.next.y == nearest;
  bvec3 axis = bvec3(x, y, !x && !y);
  walk.t = max(walk.t, nearest);
  walk.cell += mix(ivec3(0), walk.step, axis);
  walk.next = mix(walk.next, faces_ahead(walk), axis);
  return walk.t < walk.end && all(lessThan(uvec3(walk.cell), uvec3(walk.cells)));
}
