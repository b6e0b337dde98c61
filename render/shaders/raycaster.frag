// The single-pass ray caster: post-classification or pre-integration, peak finding (Knoll et al. 2009, appendix).
// DVR, PEAKS, SPLIT, ... are 0 or 1, from what the scene needs (shader_inputs/features.h).

#include "ray.glsl"
#include "statistics.glsl"
#include "field.glsl"
#include "compositing.glsl"
#include "shading.glsl"
#include "sampling.glsl"
#include "empty_cells.glsl"
#include "macrocells.glsl"
#if DVR && !PREINTEGRATED
#include "transfer_function.glsl"
#endif
#if PEAKS
#include "crossings.glsl"
#endif

layout(location = 0) out vec4 out_color;

#if LONG_RAYS
// A pass renders these of a ray's intervals: some drivers end loops that are too long.
#ifdef TRACE
const int first_interval = 0;
#define interval_count TRACED_INTERVALS
#else
uniform int first_interval, interval_count;
#endif
#endif
#if EARLY_TERMINATION
uniform float least_residual;
#define TERMINATED (transmittance < least_residual)
#else
#define TERMINATED false
#endif

#if PREINTEGRATED
#define INTERVALS_BEYOND_SEGMENTS 0
#include "march_preintegrated.glsl"
#elif PEAKS
// Interval i lies between samples i-1 and i: the n-1 between samples, and one at either end, so that each crossing
// is isolated and no value of the field is evaluated twice.
#define INTERVALS_BEYOND_SEGMENTS 1
#include "march_peaks.glsl"
#elif DVR && !BLEND_SEMI_TRANSPARENT
#define INTERVALS_BEYOND_SEGMENTS 0
#include "march_blended.glsl"
#elif DVR
#define INTERVALS_BEYOND_SEGMENTS 0

void march(Ray ray, Sampling s, int first, int last) {
  for (int i = first; i < last; ++i) {
    float t = middle_at(s, i);
    vec4 material = classify(dvr_field(at(ray, t)));
    COUNT_DVR_SAMPLE;
    composite(material.rgb * DVR_LIGHT(t), opacity_of(material.a * size_at(s, i)));
    if (TERMINATED) break;
  }
}
#else
#define INTERVALS_BEYOND_SEGMENTS 0
void march(Ray ray, Sampling s, int first, int last) {}
#endif

int interval_total(Sampling s) { return s.n + INTERVALS_BEYOND_SEGMENTS; }

// Marches the intervals [first, last) of a sampling; in passes only those that are the pass's. `index` is the number of
// intervals before this sampling's.
void march_intervals(Ray ray, Sampling s, int first, int last, int index) {
#if LONG_RAYS
  first = max(first, first_interval - index);
  last = min(last, first_interval + interval_count - index);
#endif
#ifdef TRACE
  if (first < last) traced_to = PREINTEGRATED != 0 ? boundary_at(s, last) : sample_at(s, last - 1);
#endif
  if (first < last) march(ray, s, first, last);
}

#if ADAPTIVE
// The segments that a span of macrocells meets are joined as its cells allow; one that lies in two belongs to the
// first. What is joined is sampled as a span of its own.
void march_span(Ray ray, Span span, inout int index) {
  Sampling s = sample_span(ray, span);
  Walk walk = begin_macrocells(ray, span);
  float slack = slack_of(ray, span);
  bool more = true;
  Span cells;
  int multiple;
  int marched = 0;
  while (!TERMINATED && next_macrocells(walk, more, cells, multiple)) {
    int first = max(marched, int(floor(index_at(s, cells.enter - slack))));
    marched = max(marched, min(int(floor(index_at(s, cells.exit + slack))) + 1, s.n));
    if (first >= marched) continue;
    Sampling sampling = joined(s, first, marched, multiple);
    march_intervals(ray, sampling, 0, interval_total(sampling), index);
    index += interval_total(sampling);
  }
}
#elif SKIPPING
// To take up a march costs some samples: over a gap of fewer it goes on.
const float least_gap = 8.0;

// A sample in a cell where nothing shows has no opacity, so a run begins with the first interval that reaches into an
// occupied cell. Where the segments vary, a sample is only nearly in the middle of its own: there it begins one early.
#if PREINTEGRATED || VARYING_STEPS
const float to_sample = 0.0;
const int intervals_beyond_run = 1 + INTERVALS_BEYOND_SEGMENTS;
#else
const float to_sample = 0.5;
const int intervals_beyond_run = INTERVALS_BEYOND_SEGMENTS;
#endif

// The intervals that meet a span, not before `done`, so that with skipping and without it the same samples are taken.
ivec2 run_of(Sampling s, Span shown, float slack, int done) {
  int first = int(floor(index_at(s, shown.enter - slack) + to_sample));
  int last = int(floor(index_at(s, shown.exit + slack) + to_sample)) + intervals_beyond_run;
  return ivec2(max(first, done), min(last, interval_total(s)));
}

// The walk to the next run is behind the march: in the last round of a loop, in which no lane has a run any more, SIMD
// hardware does it all once more.
void march_span(Ray ray, Span span, inout int index) {
  Sampling s = sample_span(ray, span);
  Walk walk = begin_macrocells(ray, span);
  float slack = slack_of(ray, span), gap = least_gap * (s.end - s.begin) / float(max(s.n, 1)) + 2.0 * slack;
  bool more = true;
  Span shown;
  ivec2 run = ivec2(0);
  bool found = next_shown(walk, more, gap, shown);
  while (found && !TERMINATED) {
    run = run_of(s, shown, slack, run.y);
    march_intervals(ray, s, run.x, run.y, index);
    found = next_shown(walk, more, gap, shown);
  }
  index += interval_total(s);
}
#else
void march_span(Ray ray, Span span, inout int index) {
  Sampling s = sample_span(ray, span);
  march_intervals(ray, s, 0, interval_total(s), index);
  index += interval_total(s);
}
#endif

void main() {
  Ray ray = pixel_ray();
  Span box;
  if (hit_box(ray, box.enter, box.exit)) {
    int index = 0;
#ifdef TRACE
    traced_to = box.enter;
#endif
#if DVR && !BLEND_SEMI_TRANSPARENT
    ray_length = box.exit - box.enter;
    collected = nothing_gathered;
#endif
#if EMPTY_CELLS
    Walk walk = begin_walk(ray, box, textureSize(empty_cells, 0), cell_size);
    bool more = true;
    Span span;
    while (!TERMINATED && next_span(walk, more, span)) march_span(ray, span, index);
#else
    march_span(ray, box, index);
#endif
    if (index == 0) collected = vec4(0.0);
#if STATISTICS
    counts.w |= 0x80000000u;
#endif
#ifdef TRACE
    counts.w = floatBitsToUint(traced_to - box.enter);
#endif
  }
  out_color = collected;
#if STATISTICS
  out_counts = counts;
#endif
}
