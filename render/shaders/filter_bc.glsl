// The family of Mitchell and Netravali (1988), for any B and C: 64 texels. Weights may be negative, which no fetch
// between two texels can give.

uniform mat4 bc_weights;  // times (1, u, u^2, u^3): the weights of points i-1 .. i+2 at the place u between i and i+1

// The texels around a place, and what they weigh on each axis.
struct Support {
  ivec4 x, y, z;
  vec4 weight_x, weight_y, weight_z;
};

Support support_at(vec3 position, out vec3 u) {
  vec3 place = position / cell_size, base = floor(place);
  u = place - base;
  ivec3 point = ivec3(base), last = volume_points() - 1;
  const ivec4 around = ivec4(-1, 0, 1, 2);
  vec3 squared = u * u, cubed = squared * u;
  return Support(clamp(point.x + around, 0, last.x), clamp(point.y + around, 0, last.y),
                 clamp(point.z + around, 0, last.z), bc_weights * vec4(1.0, u.x, squared.x, cubed.x),
                 bc_weights * vec4(1.0, u.y, squared.y, cubed.y), bc_weights * vec4(1.0, u.z, squared.z, cubed.z));
}

// The weights sum to 1: taken from one of the values, equal ones give exactly that.
float weighted(vec4 values, vec4 weights) { return values.y + dot(values - values.y, weights); }

vec4 bc_row(ivec4 x, int y, int z) {
  return vec4(value_at_point(ivec3(x.x, y, z)), value_at_point(ivec3(x.y, y, z)),
              value_at_point(ivec3(x.z, y, z)), value_at_point(ivec3(x.w, y, z)));
}

float bc_slice(Support s, int z) {
  return weighted(vec4(weighted(bc_row(s.x, s.y.x, z), s.weight_x), weighted(bc_row(s.x, s.y.y, z), s.weight_x),
                       weighted(bc_row(s.x, s.y.z, z), s.weight_x), weighted(bc_row(s.x, s.y.w, z), s.weight_x)),
                  s.weight_y);
}

float bc_field(vec3 position) {
  vec3 u;
  Support s = support_at(position, u);
  return weighted(vec4(bc_slice(s, s.z.x), bc_slice(s, s.z.y), bc_slice(s, s.z.z), bc_slice(s, s.z.w)), s.weight_z);
}

#if FILTER_GRADIENT
// The weights' derivatives sum to 0.
vec4 bc_slopes(float u) { return bc_weights * vec4(0.0, 1.0, 2.0 * u, 3.0 * u * u); }

float sloped(vec4 values, vec4 slopes) { return dot(values - values.y, slopes); }

// In a slice the value and its derivatives along x and y.
vec3 bc_slice_slopes(Support s, vec4 slope_x, vec4 slope_y, int z) {
  vec4 a = bc_row(s.x, s.y.x, z), b = bc_row(s.x, s.y.y, z), c = bc_row(s.x, s.y.z, z), d = bc_row(s.x, s.y.w, z);
  vec4 values = vec4(weighted(a, s.weight_x), weighted(b, s.weight_x), weighted(c, s.weight_x),
                     weighted(d, s.weight_x));
  vec4 slopes = vec4(sloped(a, slope_x), sloped(b, slope_x), sloped(c, slope_x), sloped(d, slope_x));
  return vec3(weighted(values, s.weight_y), weighted(slopes, s.weight_y), sloped(values, slope_y));
}

vec3 bc_gradient(vec3 position) {
  vec3 u;
  Support s = support_at(position, u);
  vec4 slope_x = bc_slopes(u.x), slope_y = bc_slopes(u.y), slope_z = bc_slopes(u.z);
  mat4x3 slices = mat4x3(bc_slice_slopes(s, slope_x, slope_y, s.z.x), bc_slice_slopes(s, slope_x, slope_y, s.z.y),
                         bc_slice_slopes(s, slope_x, slope_y, s.z.z), bc_slice_slopes(s, slope_x, slope_y, s.z.w));
  mat3x4 along_z = transpose(slices);  // the value and its two derivatives, each in the four slices
  return vec3(weighted(along_z[1], s.weight_z), weighted(along_z[2], s.weight_z), sloped(along_z[0], slope_z)) /
         cell_size;
}
#endif
