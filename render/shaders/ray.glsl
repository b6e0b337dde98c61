// The ray of a pixel. Lengths are in units of the smallest spacing, positions run from the box's first point, so
// that the picture does not change with the world's units.

uniform vec3 box_size, cell_size;
uniform vec3 rendered_min, rendered_max;  // of the part of the box that is rendered
uniform vec2 image_size;
// A point on the ray through the image plane's (x, y) is ray_anchor + x*ray_anchor_u + y*ray_anchor_v: a plane
// through the volume's middle, not the eye, so that a far eye costs no precision. In parallel projection ray_u and ray_v
// are 0.
uniform vec3 ray_anchor, ray_anchor_u, ray_anchor_v;
uniform vec3 ray_w, ray_u, ray_v;  // the direction is w + x*u + y*v
uniform float eye_to_anchor;       // along w

struct Ray {
  vec3 origin, direction;  // direction has length 1
  float eye;               // where it begins: the eye's place along it, or one before the box
};

// Engines and passes must find the same samples to the bit: what leads to them is `precise`, since a compiler may else
// contract a product and a sum in one place and not in another.
vec3 at(Ray ray, float t) {
  precise vec3 position = ray.origin + t * ray.direction;
  return position;
}

#ifdef TRACE
// All pixels draw one ray, the n-th one its first n intervals (raycaster/trace_ray.h).
uniform vec2 traced_pixel;
uniform int trace_width;
#define PIXEL traced_pixel
#define TRACED_INTERVALS (int(gl_FragCoord.y) * trace_width + int(gl_FragCoord.x))
#else
#define PIXEL gl_FragCoord.xy
#endif

// Row 0 is at the top; the ray goes through the pixel's centre.
Ray pixel_ray() {
  precise vec2 plane = vec2(2.0, -2.0) * PIXEL / image_size + vec2(-1.0, 1.0);
  precise vec3 towards = ray_w + plane.x * ray_u + plane.y * ray_v;
  precise float size = sqrt(towards.x * towards.x + towards.y * towards.y + towards.z * towards.z);
  precise vec3 origin = ray_anchor + plane.x * ray_anchor_u + plane.y * ray_anchor_v, direction = towards / size;
  precise float eye = -eye_to_anchor * size;
  return Ray(origin, direction, eye);
}

// Where the ray is inside a box and in front of the eye. A ray that runs in a face is inside.
bool hit_box(Ray ray, vec3 low, vec3 high, out float enter, out float exit) {
  enter = ray.eye;
  exit = 3.0e38;
  if (any(greaterThan(low, high))) return false;
  for (int axis = 0; axis < 3; ++axis) {
    float o = ray.origin[axis], d = ray.direction[axis];
    if (d == 0.0) {
      if (o < low[axis] || o > high[axis]) return false;
      continue;
    }
    precise float a = (low[axis] - o) / d, b = (high[axis] - o) / d;
    enter = max(enter, min(a, b));
    exit = min(exit, max(a, b));
  }
  return enter <= exit;
}

// The same for the rendered box.
bool hit_box(Ray ray, out float enter, out float exit) { return hit_box(ray, rendered_min, rendered_max, enter, exit); }
