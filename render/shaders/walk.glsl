// A walk along a ray from cell to cell of a grid (Amanatides and Woo 1987).

#include "spans.glsl"

struct Walk {
  ivec3 cells;  // of the grid
  ivec3 cell, step;
  vec3 next, delta;  // where the ray meets the next face of each axis, and how far it is from face to face
  float t, end;
};

Walk begin_walk(Ray ray, Span span, ivec3 cells, vec3 size) {
  Walk walk;
  walk.cells = cells;
  vec3 origin = ray.origin / size, direction = ray.direction / size;
  walk.cell = clamp(ivec3(floor(origin + span.enter * direction)), ivec3(0), cells - 1);
  for (int axis = 0; axis < 3; ++axis) {
    float d = direction[axis];
    walk.step[axis] = d > 0.0 ? 1 : -1;
    walk.delta[axis] = d == 0.0 ? 0.0 : abs(1.0 / d);
    float face = float(walk.cell[axis] + (d > 0.0 ? 1 : 0));
    walk.next[axis] = d == 0.0 ? 3.0e38 : (face - origin[axis]) / d;
  }
  walk.t = span.enter;
  walk.end = span.exit;
  return walk;
}

// To the next cell; false at the end of the ray.
bool advance(inout Walk walk) {
  int axis = walk.next.x <= walk.next.y ? (walk.next.x <= walk.next.z ? 0 : 2) : (walk.next.y <= walk.next.z ? 1 : 2);
  walk.t = max(walk.t, walk.next[axis]);
  walk.next[axis] += walk.delta[axis];
  walk.cell[axis] += walk.step[axis];
  return walk.t < walk.end && walk.cell[axis] >= 0 && walk.cell[axis] < walk.cells[axis];
}
