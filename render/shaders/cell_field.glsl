// The trilinear field in a cell of a walk. Along the ray it is a cubic in the share s of the ray's part in the cell
// (Marmitt et al. 2004).

#include "cell_walk.glsl"
#include "field.glsl"

struct CellCorners {
  vec4 low, high;  // at x = 0 and x = 1: of (y, z) = (0, 0), (1, 0), (0, 1), (1, 1)
};

float point_value(CellWalk walk, ivec3 corner) {
  return value_at_point(walk.first + walk.step * (walk.cell + corner));
}

CellCorners corners_of(CellWalk walk) {
  CellCorners c;
  c.low = vec4(point_value(walk, ivec3(0, 0, 0)), point_value(walk, ivec3(0, 1, 0)),
               point_value(walk, ivec3(0, 0, 1)), point_value(walk, ivec3(0, 1, 1)));
  c.high = vec4(point_value(walk, ivec3(1, 0, 0)), point_value(walk, ivec3(1, 1, 0)),
                point_value(walk, ivec3(1, 0, 1)), point_value(walk, ivec3(1, 1, 1)));
  return c;
}

// Those of the cell that a walk has come to, from those of the cell before: four are the same.
CellCorners next_corners(CellWalk walk, CellCorners c) {
  bool x = walk.entered.x, y = walk.entered.y;
  ivec3 u = walk.step * (x ? ivec3(0, 1, 0) : ivec3(1, 0, 0)), v = walk.step * (x || y ? ivec3(0, 0, 1) : ivec3(0, 1, 0));
  ivec3 point = walk.first + walk.step * (walk.cell + ivec3(walk.entered));
  vec4 far = vec4(value_at_point(point), value_at_point(point + u),
                  value_at_point(point + v), value_at_point(point + u + v));
  CellCorners along_x = CellCorners(c.high, far);
  CellCorners along_y = CellCorners(vec4(c.low.y, far.x, c.low.w, far.z), vec4(c.high.y, far.y, c.high.w, far.w));
  CellCorners along_z = CellCorners(vec4(c.low.zw, far.xz), vec4(c.high.zw, far.yw));
  return CellCorners(mix(mix(along_z.low, along_y.low, bvec4(y)), along_x.low, bvec4(x)),
                     mix(mix(along_z.high, along_y.high, bvec4(y)), along_x.high, bvec4(x)));
}

vec2 range_of(CellCorners c) {
  vec4 least = min(c.low, c.high), most = max(c.low, c.high);
  return vec2(min(min(least.x, least.y), min(least.z, least.w)), max(max(most.x, most.y), max(most.z, most.w)));
}

// Exact at both ends, and where they are equal. So a face of equal values has that value, and a face's values are the
// same to the bit in both of its cells.
float lerp(float a, float b, float u) {
  precise float value = u < 0.5 ? a + (b - a) * u : b - (b - a) * (1.0 - u);
  return value;
}

float value_at(CellCorners c, vec3 place) {
  vec4 edges = vec4(lerp(c.low.x, c.high.x, place.x), lerp(c.low.y, c.high.y, place.x),
                    lerp(c.low.z, c.high.z, place.x), lerp(c.low.w, c.high.w, place.x));
  return lerp(lerp(edges.x, edges.y, place.y), lerp(edges.z, edges.w, place.y), place.z);
}

// x s + y s^2 + z s^3: the field's rise from the entry, along the way from one place in the cell to another.
vec3 rise_along(CellCorners c, vec3 from, vec3 to) {
  vec3 d = to - from;
  vec4 low = c.low - c.low.x, along_x = c.high - c.low;
  vec4 e0 = low + along_x * from.x, e1 = along_x * d.x;
  vec2 step0 = e0.yw - e0.xz, step1 = e1.yw - e1.xz;
  vec2 q0 = e0.xz + step0 * from.y, q1 = e1.xz + step1 * from.y + step0 * d.y, q2 = step1 * d.y;
  float c0 = q0.y - q0.x, c1 = q1.y - q1.x, c2 = q2.y - q2.x;
  return vec3(q1.x + c1 * from.z + c0 * d.z, q2.x + c2 * from.z + c1 * d.z, c2 * d.z);
}

float rise_at(vec3 p, float s) { return s * (p.x + s * (p.y + s * p.z)); }

// The same polynomial from s on.
vec3 rise_from(vec3 p, float s) {
  return vec3(p.x + s * (2.0 * p.y + 3.0 * p.z * s), p.y + 3.0 * p.z * s, p.z);
}

// Where it turns in (0, 1), ascending; 1 where it does not.
vec2 turns_of(vec3 p) {
  float a = 3.0 * p.z, b = p.y, c = p.x, discriminant = b * b - a * c;
  if (!(discriminant > 0.0)) return vec2(1.0);
  float q = -(b + (b < 0.0 ? -1.0 : 1.0) * sqrt(discriminant));
  vec2 roots = vec2(c / q, a == 0.0 ? 1.0 : q / a);
  roots = mix(vec2(1.0), roots, bvec2(roots.x > 0.0 && roots.x < 1.0, roots.y > 0.0 && roots.y < 1.0));
  return vec2(min(roots.x, roots.y), max(roots.x, roots.y));
}

// A bracket of a root, and the best place in it that is known.
struct Root {
  float low, high, at;
};

// To where the parabola that touches the cubic there comes to `target`; where that leaves the bracket, to its middle.
Root improve(Root root, vec3 p, float target, bool up) {
  float value = rise_at(p, root.at) - target;
  if ((value < 0.0) == up) root.low = root.at; else root.high = root.at;
  float slope = p.x + root.at * (2.0 * p.y + 3.0 * p.z * root.at), bend = 2.0 * p.y + 6.0 * p.z * root.at;
  float steep = sqrt(max(slope * slope - 2.0 * value * bend, 0.0));
  float next = root.at - 2.0 * value / (slope + (up ? steep : -steep));
  root.at = next >= root.low && next <= root.high ? next : 0.5 * (root.low + root.high);
  return root;
}

// Where the rise, monotone on [0, size] and `rise` at its end, comes to `target`. Four steps are enough, where Newton's
// method needs more beside extrema (Analytic.RandomScenesAreExact); a loop until nothing changes is slower on SIMD
// hardware, where it takes as many rounds as the slowest lane.
float solve_rise(vec3 p, float target, float size, float rise) {
  bool up = rise >= 0.0;
  Root root = Root(0.0, size, rise == 0.0 ? 0.0 : clamp(size * (target / rise), 0.0, size));
  root = improve(root, p, target, up);
  root = improve(root, p, target, up);
  root = improve(root, p, target, up);
  root = improve(root, p, target, up);
  return root.at;
}
