// Steps that grow with the distance from the eye, whatever the step length is set to. Boundaries are at T(x) from the
// eye, x = 0, 1, 2, ..., and those in the span cut it.
//   DIFFERENTIAL (Knoll et al. 2009, section 5): the increments of eq. 17 sum to T(x) = b x + a x(x-1)/2, with b = k,
//     a = k |dD/dx|; the image plane is at distance 1, and k is s_k pixels' diagonals on it.
//   FOOTPRINT: T(x) = (1+k)^x - 1 with k as above, but of the pixel as its ray sees it: a step is in proportion to the
//     distance from the eye and one spacing more, so that it begins like the other.
// In parallel projection both are DIFFERENTIAL with |dD/dx| = 0: equal steps of s_k pixels' diagonals.

uniform float s_k, pixel_diagonal;  // at distance 1, or in parallel projection everywhere

// The ray's direction D, as its pixel is passed: |dD/dx| and |dD/dy| (eq. 10), x and y in [-1,1] across the image.
vec2 spread_of(Ray ray) {
  vec2 along = vec2(dot(ray_u, ray.direction), dot(ray_v, ray.direction));
  vec2 across = vec2(dot(ray_u, ray_u), dot(ray_v, ray_v)) - along * along;
  return sqrt(max(across, vec2(0.0))) * dot(ray.direction, ray_w);
}

Sampling sample_span(Ray ray, Span span) {
  float from = span.enter - ray.eye, size = span.exit - span.enter;
  vec2 spread = spread_of(ray);
  Sampling s;
  s.span = span;
  s.begin = span.enter;
  s.end = span.exit;
#if FOOTPRINT
  float k = s_k * length(spread * 2.0 / image_size);
  s.growth = (k < 0.01 ? k * (1.0 - k * (0.5 - k / 3.0)) : log(1.0 + k)) / log(2.0);
  s.dt = 1.0;
  float to_next = (from + 1.0) * (exp2(s.growth * (1.0 - fract(count_of(s, from)))) - 1.0);
  s.dt = from + to_next + 1.0;
#else
  s.dt = s_k * pixel_diagonal;
  s.growth = s.dt * spread.x;
  // The step that holds the entry ends at T(floor(x) + 1): the difference of both T's, without their size
  float x = count_of(s, from), left = 1.0 - fract(x);
  float to_next = left * (s.dt + s.growth * (x - 0.5 + 0.5 * left));
  s.dt += s.growth * (floor(x) + 1.0);
#endif
  s.second = span.enter + min(to_next, size);
  s.n = 1 + int(ceil(count_of(s, max(size - to_next, 0.0))));
  return s;
}
