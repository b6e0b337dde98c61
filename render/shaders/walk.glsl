// A walk along a ray from cell to cell of a grid (Amanatides and Woo 1987). Where the ray meets a face follows from the
// face's index each time: a sum of distances from face to face would drift by more than positions are rounded.

#include "spans.glsl"

struct Walk {
  ivec3 cells;  // of the grid
  ivec3 cell, step;
  vec3 origin, direction, inverse, size;  // of the ray; its direction, and one by it; of a cell
  bvec3 is_parallel;
  float t, end;
};

Walk begin_walk(Ray ray, Span span, ivec3 cells, vec3 size) {
  Walk walk;
  walk.cells = cells;
  walk.cell = clamp(ivec3(floor(at(ray, span.enter) / size)), ivec3(0), cells - 1);
  walk.step = mix(ivec3(-1), ivec3(1), greaterThan(ray.direction, vec3(0.0)));
  walk.origin = ray.origin;
  walk.direction = ray.direction;
  walk.inverse = 1.0 / ray.direction;
  walk.size = size;
  walk.is_parallel = lessThan(abs(ray.direction), vec3(1.0e-30));
  walk.t = span.enter;
  walk.end = span.exit;
  return walk;
}

// To where the ray leaves the cells that are fewer than `reach` cells away on each axis: for 1 to the next cell. False at
// the end of the ray. (Masks in place of an index: drivers put vectors that are indexed by a variable into memory.)
bool advance(inout Walk walk, int reach) {
  ivec3 last = walk.cell + (reach - 1) * walk.step;
  vec3 faces = vec3(last + max(walk.step, ivec3(0))) * walk.size;
  vec3 next = mix((faces - walk.origin) * walk.inverse, vec3(3.0e38), walk.is_parallel);
  float nearest = min(next.x, min(next.y, next.z));
  bool x = next.x == nearest, y = !x && next.y == nearest;
  walk.t = max(walk.t, nearest);
  ivec3 cell = ivec3(floor((walk.origin + walk.t * walk.direction) / walk.size));
  cell = clamp(cell, min(walk.cell, last), max(walk.cell, last));
  walk.cell = mix(cell, last + walk.step, bvec3(x, y, !x && !y));
  return walk.t < walk.end && all(lessThan(uvec3(walk.cell), uvec3(walk.cells)));
}

bool advance(inout Walk walk) { return advance(walk, 1); }
