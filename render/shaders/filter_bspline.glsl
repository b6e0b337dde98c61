// The cubic B-spline (Mitchell and Netravali's B = 1, C = 0) by eight trilinear fetches instead of 64 texels (Sigg and
// Hadwiger, GPU Gems 2, chapter 20): no weight is negative, so that two neighbours on an axis, and what each of them
// weighs, are one fetch between them. The pairs weigh g and 1 - g, which are at least 1/6: nothing cancels. A fetch is
// as good as the texture unit's weights: with 8 bits the field has stairs of up to 1/512 of a neighbours' difference.

// Where the fetches of points i-1 and i and of i+1 and i+2 lie, on each axis, in coordinates of the texture.
struct Pairs {
  vec3 first, second;
};

// From how far each lies from its first point.
Pairs pairs_around(vec3 base, vec3 first, vec3 second) {
  vec3 size = vec3(volume_points());
  return Pairs((base - 0.5 + first) / size, (base + 1.5 + second) / size);
}

float value_at(float x, float y, float z) { return value_between(vec3(x, y, z)); }

void fetch(Pairs p, out vec4 low, out vec4 high) {
  vec3 a = p.first, b = p.second;
  low = vec4(value_at(a.x, a.y, a.z), value_at(a.x, b.y, a.z), value_at(a.x, a.y, b.z), value_at(a.x, b.y, b.z));
  high = vec4(value_at(b.x, a.y, a.z), value_at(b.x, b.y, a.z), value_at(b.x, a.y, b.z), value_at(b.x, b.y, b.z));
}

// Of the place u between the points i and i+1: the pairs, and what the first one weighs.
Pairs bspline_pairs(vec3 base, vec3 u, out vec3 weight) {
  vec3 v = 1.0 - u;
  vec3 inner = (4.0 - 3.0 * u * u * (1.0 + v)) / 6.0;
  weight = inner + v * v * v / 6.0;
  return pairs_around(base, inner / weight, u * u * u / (6.0 * (1.0 - weight)));
}

float bspline_field(vec3 position) {
  vec3 place = position / cell_size, base = floor(place), weight;
  vec4 low, high;
  fetch(bspline_pairs(base, place - base, weight), low, high);
  vec4 edges = high + (low - high) * weight.x;
  vec2 face = edges.yw + (edges.xz - edges.yw) * weight.y;
  return face.y + (face.x - face.y) * weight.z;
}

#if FILTER_GRADIENT
// The derivative on one axis: there neither pair's slopes change their sign, so they too are one fetch each, and weigh
// -s and s = 1/2 + u (1 - u). On the others the pairs and their weights are the field's.
float bspline_slope(Pairs field, Pairs slope, vec3 weight, float s, vec3 axis) {
  vec4 low, high;
  fetch(Pairs(mix(field.first, slope.first, axis), mix(field.second, slope.second, axis)), low, high);
  vec3 a = mix(weight, vec3(-s), axis), b = mix(1.0 - weight, vec3(s), axis);
  vec4 edges = low * a.x + high * b.x;
  vec2 face = edges.xz * a.y + edges.yw * b.y;
  return face.x * a.z + face.y * b.z;
}

vec3 bspline_gradient(vec3 position) {
  vec3 place = position / cell_size, base = floor(place), u = place - base, weight;
  Pairs field = bspline_pairs(base, u, weight);
  vec3 s = 0.5 + u * (1.0 - u);
  Pairs slope = pairs_around(base, u * (4.0 - 3.0 * u) / (2.0 * s), u * u / (2.0 * s));
  return vec3(bspline_slope(field, slope, weight, s.x, vec3(1.0, 0.0, 0.0)),
              bspline_slope(field, slope, weight, s.y, vec3(0.0, 1.0, 0.0)),
              bspline_slope(field, slope, weight, s.z, vec3(0.0, 0.0, 1.0))) / cell_size;
}
#endif
