// A walk along a ray through the grid's cells. The axes along which the ray goes down are mirrored, so that it goes up
// along all: each cell is entered at 0 and left at 1. A cell begins at the place where the one before ended, to the bit.

#include "spans.glsl"

struct CellWalk {
  ivec3 cells;                      // of the grid
  ivec3 first, step;                // a mirrored point p is the grid's point first + step p
  ivec3 cell;                       // mirrored
  vec3 origin, direction, inverse;  // of the ray, mirrored, in cells
  vec3 place;                       // in the cell, in [0, 1]
  float t, end;
};

vec3 cell_place_at(CellWalk walk, float t) {
  precise vec3 place = (walk.origin - vec3(walk.cell)) + t * walk.direction;
  return clamp(place, vec3(0.0), vec3(1.0));
}

CellWalk begin_cell_walk(Ray ray, Span span) {
  CellWalk walk;
  walk.cells = textureSize(volume, 0) - 1;
  bvec3 down = lessThan(ray.direction, vec3(0.0));
  walk.first = mix(ivec3(0), walk.cells, down);
  walk.step = mix(ivec3(1), ivec3(-1), down);
  vec3 origin = ray.origin / cell_size;
  walk.origin = mix(origin, vec3(walk.cells) - origin, down);
  walk.direction = abs(ray.direction) / cell_size;
  walk.inverse = 1.0 / walk.direction;
  walk.t = span.enter;
  walk.end = span.exit;
  precise vec3 position = walk.origin + walk.t * walk.direction;
  walk.cell = clamp(ivec3(floor(position)), ivec3(0), walk.cells - 1);
  walk.place = cell_place_at(walk, walk.t);
  return walk;
}

// Where the ray leaves the cell: `face` is the axis of the face, or none at the walk's end.
struct CellExit {
  float t;
  vec3 place;
  bvec3 face;
};

CellExit exit_of(CellWalk walk) {
  vec3 faces = vec3(walk.cell + 1);
  vec3 next = mix((faces - walk.origin) * walk.inverse, vec3(3.0e38), lessThan(walk.direction, vec3(1.0e-30)));
  float nearest = min(next.x, min(next.y, next.z));
  bool x = next.x == nearest, y = !x && next.y == nearest;
  CellExit leave;
  leave.t = max(walk.t, min(nearest, walk.end));
  leave.face = bvec3(x, y, !x && !y);
  leave.face = bvec3(ivec3(leave.face) * int(nearest < walk.end));
  leave.place = max(walk.place, mix(cell_place_at(walk, leave.t), vec3(1.0), leave.face));
  return leave;
}

// To the next cell; false at the walk's end.
bool advance(inout CellWalk walk, CellExit leave) {
  walk.t = leave.t;
  walk.place = mix(leave.place, vec3(0.0), leave.face);
  walk.cell += ivec3(leave.face);
  return any(leave.face) && all(lessThan(walk.cell, walk.cells));
}
