// Trilinear in float, from eight texels. a + (b - a) u is a at u = 0, and a everywhere if b is: the value at a point and
// on a face of equal values is exact, if the grid's last point is the lower one of a cell of its own.

struct Corners {
  vec4 low, high;  // at the cell's lower and upper x: of (y, z) = (0, 0), (1, 0), (0, 1), (1, 1)
  vec3 place;      // in the cell
};

Corners corners_at(vec3 position, ivec3 last_cell) {
  vec3 place = position / cell_size;
  ivec3 a = clamp(ivec3(floor(place)), ivec3(0), last_cell), b = min(a + 1, volume_points() - 1);
  Corners corners;
  corners.low = vec4(value_at_point(a), value_at_point(ivec3(a.x, b.y, a.z)),
                     value_at_point(ivec3(a.xy, b.z)), value_at_point(ivec3(a.x, b.yz)));
  corners.high = vec4(value_at_point(ivec3(b.x, a.yz)), value_at_point(ivec3(b.xy, a.z)),
                      value_at_point(ivec3(b.x, a.y, b.z)), value_at_point(b));
  corners.place = max(place - vec3(a), vec3(0.0));
  return corners;
}

float linear_exact_field(vec3 position) {
  Corners c = corners_at(position, volume_points() - 1);
  vec4 edges = c.low + (c.high - c.low) * c.place.x;
  vec2 face = edges.xz + (edges.yw - edges.xz) * c.place.y;
  return face.x + (face.y - face.x) * c.place.z;
}

#if FILTER_GRADIENT
// The trilinear field's own derivative, which jumps at the cells' faces.
vec3 linear_exact_gradient(vec3 position) {
  Corners c = corners_at(position, volume_points() - 2);
  vec4 rise_x = c.high - c.low, edges = c.low + rise_x * c.place.x;
  vec2 face_x = rise_x.xz + (rise_x.yw - rise_x.xz) * c.place.y;
  vec2 rise_y = edges.yw - edges.xz, face = edges.xz + rise_y * c.place.y;
  return vec3(face_x.x + (face_x.y - face_x.x) * c.place.z, rise_y.x + (rise_y.y - rise_y.x) * c.place.z,
              face.y - face.x) / cell_size;
}
#endif
