// The single-pass ray caster: uniform steps, post-classification or pre-integration, peak finding (Knoll et al. 2009,
// appendix).
// DVR, PEAKS, SPLIT, ... are 0 or 1, from what the scene needs (raycaster/features.h).

#include "ray.glsl"
#include "statistics.glsl"
#include "field.glsl"
#include "compositing.glsl"
#include "shading.glsl"
#include "placement.glsl"
#if DVR && !PREINTEGRATED
#include "transfer_function.glsl"
#endif
#if PEAKS
#include "crossings.glsl"
#endif

layout(location = 0) out vec4 out_color;

#if LONG_RAYS
// A pass renders these of a ray's intervals: some drivers end loops that are too long.
uniform int first_interval, interval_count;
#endif
#if EARLY_TERMINATION
uniform float least_residual;
#define TERMINATED (transmittance < least_residual)
#else
#define TERMINATED false
#endif

#if DVR && PREINTEGRATED
#include "march_preintegrated.glsl"
int interval_total(Sampling s) { return segment_count(s); }
#elif PEAKS
// Interval i lies between samples i-1 and i: the n-1 between samples, and one at either end, so that each crossing
// is isolated and no value of the field is evaluated twice.
int interval_total(Sampling s) { return s.n + 1; }
#include "march_peaks.glsl"
#elif DVR
int interval_total(Sampling s) { return s.n; }

void march(Ray ray, Sampling s, int first, int last) {
  for (int i = first; i < last; ++i) {
    float t = middle_at(s, i);
    vec4 material = classify(field(at(ray, t)));
    COUNT_DVR_SAMPLE;
    composite(material.rgb * LIGHT(t), opacity_of(material.a * s.dt));
    if (TERMINATED) break;
  }
}
#else
int interval_total(Sampling s) { return 0; }
void march(Ray ray, Sampling s, int first, int last) {}
#endif

// Renders a span; in passes only the intervals [first_interval, first_interval + interval_count) of those before
// `index` and after.
void march_span(Ray ray, Span span, inout int index) {
  Sampling s = sample_span(ray, span);
  int total = interval_total(s);
#if LONG_RAYS
  int first = max(first_interval - index, 0), last = min(first_interval + interval_count - index, total);
  if (first < last) march(ray, s, first, last);
  index += total;
#else
  march(ray, s, 0, total);
#endif
}

void main() {
  Ray ray = pixel_ray();
  Span box;
  if (hit_box(ray, box.enter, box.exit)) {
    int index = 0;
#if EMPTY_CELLS
    Walk walk = begin_walk(ray, box);
    bool more = true;
    Span span;
    while (next_span(walk, more, span)) march_span(ray, span, index);
#else
    march_span(ray, box, index);
#endif
#if STATISTICS
    counts.w |= 0x80000000u;
#endif
  }
  out_color = collected;
#if STATISTICS
  out_counts = counts;
#endif
}
