// The stretches of a ray that are rendered: its part in the box, cut where it meets a cell with a NaN or Inf corner.

#include "ray.glsl"

struct Span {
  float enter, exit;
};

#if EMPTY_CELLS
#include "field.glsl"
uniform usampler3D empty_cells;  // 1 = this cell has a corner without a value

// A walk along the ray from cell to cell (Amanatides and Woo 1987).
struct Walk {
  ivec3 cell, step;
  vec3 next, delta;  // where the ray meets the next face of each axis, and how far it is from face to face
  float t, end;
};

Walk begin_walk(Ray ray, Span box) {
  Walk walk;
  ivec3 cells = textureSize(empty_cells, 0);
  vec3 origin = ray.origin / cell_size, direction = ray.direction / cell_size;
  walk.cell = clamp(ivec3(floor(origin + box.enter * direction)), ivec3(0), cells - 1);
  for (int axis = 0; axis < 3; ++axis) {
    float d = direction[axis];
    walk.step[axis] = d > 0.0 ? 1 : -1;
    walk.delta[axis] = d == 0.0 ? 0.0 : abs(1.0 / d);
    float face = float(walk.cell[axis] + (d > 0.0 ? 1 : 0));
    walk.next[axis] = d == 0.0 ? 3.0e38 : (face - origin[axis]) / d;
  }
  walk.t = box.enter;
  walk.end = box.exit;
  return walk;
}

// To the next cell; false at the end of the ray.
bool advance(inout Walk walk) {
  int axis = walk.next.x <= walk.next.y ? (walk.next.x <= walk.next.z ? 0 : 2) : (walk.next.y <= walk.next.z ? 1 : 2);
  walk.t = max(walk.t, walk.next[axis]);
  walk.next[axis] += walk.delta[axis];
  walk.cell[axis] += walk.step[axis];
  return walk.t < walk.end && walk.cell[axis] >= 0 && walk.cell[axis] < textureSize(empty_cells, 0)[axis];
}

bool is_empty(Walk walk) { return texelFetch(empty_cells, walk.cell, 0).r != 0u; }

// The next stretch without empty cells. `more` is whether the walk has a cell left.
bool next_span(inout Walk walk, inout bool more, out Span span) {
  while (more && is_empty(walk)) more = advance(walk);
  span = Span(walk.t, walk.end);
  if (!more) return false;
  do more = advance(walk);
  while (more && !is_empty(walk));
  if (more) span.exit = walk.t;
  return true;
}
#endif
