// Begins a picture by VDLS: each ray's first sample, delta vector and sample count (section 3.1), and the greatest count of
// each leaf of the screen quadtree (section 4.2). The samples are the ray caster's, from the same functions.

#include "ray.glsl"
#include "sampling.glsl"
#include "vdls_samples.glsl"

layout(location = 0) out vec4 out_color;
layout(location = 1) out ivec4 layer_sample;
layout(location = 2) out ivec4 delta_vector;
#if COUNTS
layout(location = 3) out uvec4 out_counts;  // as statistics.glsl's
#endif
layout(std430, binding = 1) buffer LeafCounts { uint leaf_counts[]; };
uniform int leaf_side, leaves;        // of a leaf in pixels; leaves on each axis
uniform vec3 visible_min, visible_max;  // beyond this box every sample is transparent

// The samples [first, last) of the ray that may lie in the visible box, with one to spare at either end for rounding.
// Which samples there are does not change: the others only contribute nothing.
void leap(Ray ray, Sampling s, out int first, out int last) {
  Span visible;
  first = last = 0;
  if (!hit_box(ray, visible_min, visible_max, visible.enter, visible.exit)) return;
  first = clamp(int(floor((visible.enter - s.begin) / s.dt)) - 1, 0, s.n);
  last = clamp(int(ceil((visible.exit - s.begin) / s.dt)) + 1, first, s.n);
}

void main() {
  out_color = vec4(0.0);
  layer_sample = delta_vector = ivec4(0);
  Ray ray = pixel_ray();
  Span box;
  bool hit = hit_box(ray, box.enter, box.exit);
  if (hit) {
    Sampling s = sample_span(ray, box);
    int first, last;
    leap(ray, s, first, last);
#if BACK_TO_FRONT
    vec3 start = at(ray, middle_at(s, last - 1)), delta = -s.dt * ray.direction;
#else
    vec3 start = at(ray, middle_at(s, first)), delta = s.dt * ray.direction;
#endif
    layer_sample = ivec4(round(start / fixed_unit), 0);
    delta_vector = ivec4(round(delta / delta_unit()), last - first);
    if (last > first) out_color = vec4(BLEND_MINIMUM);
    ivec2 leaf = ivec2(gl_FragCoord.xy) / leaf_side;
    atomicMax(leaf_counts[leaf.y * leaves + leaf.x], uint(last - first));
  }
#if COUNTS
  out_counts = uvec4(delta_vector.w, delta_vector.w, 0u, hit ? 0x80000000u : 0u);
#endif
}
