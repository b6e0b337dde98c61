// A walk along a ray through the grid's cells. The axes along which the ray goes down are mirrored, so that it goes up
// along all: each cell is entered at 0 and left at 1.

#include "spans.glsl"

struct CellWalk {
  ivec3 cells;                      // of the grid
  ivec3 first, step;                // a mirrored point p is the grid's point first + step p
  ivec3 cell;                       // mirrored
  vec3 origin, direction, inverse;  // of the ray, mirrored, in cells
  bvec3 entered;                    // the axis whose face was entered, or none where the walk began
  float t, end;                     // where the ray enters the cell; where the walk ends
};

CellWalk begin_cell_walk(Ray ray, Span span) {
  CellWalk walk;
  walk.cells = volume_points() - 1;
  bvec3 down = lessThan(ray.direction, vec3(0.0));
  walk.first = mix(ivec3(0), walk.cells, down);
  walk.step = mix(ivec3(1), ivec3(-1), down);
  vec3 origin = ray.origin / cell_size;
  walk.origin = mix(origin, vec3(walk.cells) - origin, down);
  walk.direction = abs(ray.direction) / cell_size;
  walk.inverse = min(1.0 / walk.direction, vec3(1.0e30));
  walk.entered = bvec3(false);
  walk.t = span.enter;
  walk.end = span.exit;
  precise vec3 position = walk.origin + walk.t * walk.direction;
  walk.cell = clamp(ivec3(floor(position)), ivec3(0), walk.cells - 1);
  return walk;
}

// The place in the cell, from 0 to 1, at t. Where a cell ends is so to the bit where the next one begins.
vec3 cell_place_at(CellWalk walk, float t) {
  precise vec3 place = (walk.origin - vec3(walk.cell)) + t * walk.direction;
  return clamp(place, vec3(0.0), vec3(1.0));
}

// Where the ray leaves the cell: `face` is the axis of the face, or none at the walk's end.
struct CellExit {
  float t;
  bvec3 face;
};

CellExit exit_of(CellWalk walk) {
  vec3 ahead = vec3(walk.cell + 1) - walk.origin;
  vec3 next = mix(ahead * walk.inverse, vec3(3.0e38), lessThan(walk.direction, vec3(1.0e-30)));
  float nearest = min(next.x, min(next.y, next.z));
  bool goes_on = nearest < walk.end, x = next.x == nearest, y = !x && next.y == nearest;
  return CellExit(max(walk.t, min(nearest, walk.end)),
                  bvec3(x && goes_on, y && goes_on, !x && !y && goes_on));
}

vec3 entry_place(CellWalk walk) { return mix(cell_place_at(walk, walk.t), vec3(0.0), walk.entered); }
vec3 exit_place(CellWalk walk, CellExit leave) { return mix(cell_place_at(walk, leave.t), vec3(1.0), leave.face); }

// To the next cell; false at the walk's end.
bool advance(inout CellWalk walk, CellExit leave) {
  walk.t = leave.t;
  walk.entered = leave.face;
  walk.cell += ivec3(leave.face);
  return any(leave.face) && all(lessThan(walk.cell, walk.cells));
}
