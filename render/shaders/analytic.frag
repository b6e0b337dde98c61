// The exact ray caster: cell by cell (march_cells.glsl). DVR, PEAKS, ... are 0 or 1, from what the scene needs
// (shader_inputs/features.h).

#include "ray.glsl"
#include "statistics.glsl"
#include "field.glsl"
#include "compositing.glsl"
#include "macrocells.glsl"

layout(location = 0) out vec4 out_color;

#if LONG_RAYS
// A pass renders these of a ray's intervals, each one smallest spacing long: some drivers end loops that are too long.
#ifdef TRACE
const int first_interval = 0;
#define interval_count TRACED_INTERVALS
#else
uniform int first_interval, interval_count;
#endif
precise float pass_begin;
#endif
#if EARLY_TERMINATION
uniform float least_residual;
#define TERMINATED (transmittance < least_residual)
#elif STATISTICS
#define TERMINATED false  // crossings behind what is opaque are counted
#else
#define TERMINATED (transmittance < 1.0e-9)  // nothing behind shows
#endif

#include "march_cells.glsl"

// To take up a march costs some cells: over a gap of this many smallest spacings it goes on.
const float least_gap = 10.0;

void march_span(Ray ray, Span span) {
#if SKIPPING
  Walk walk = begin_macrocells(ray, span);
  float slack = slack_of(ray, span), done = span.enter;
  bool more = true;
  Span shown;
  bool found = next_shown(walk, more, least_gap, shown);
  while (found && !TERMINATED) {
    Span part = Span(max(shown.enter - slack, done), min(shown.exit + slack, span.exit));
    done = max(done, part.exit);
    if (part.enter < part.exit) march_cells(ray, part);
    found = next_shown(walk, more, least_gap, shown);
  }
#else
  march_cells(ray, span);
#endif
}

void main() {
  Ray ray = pixel_ray();
  Span span;
  bool is_hit = hit_box(ray, span.enter, span.exit) && span.enter < span.exit;
  if (is_hit) {
#if STATISTICS
    counts.w |= 0x80000000u;
#endif
#if LONG_RAYS
    pass_begin = span.enter + float(first_interval);
    precise float end = span.enter + float(first_interval + interval_count);
    span = Span(pass_begin, min(span.exit, end));
#endif
#if DVR || PEAKS
    if (span.enter < span.exit) march_span(ray, span);
#endif
  }
#if STATISTICS
  // A ray beside the box by less than places are rounded
  vec3 margin = vec3(rounding * (greatest(abs(ray.origin)) + greatest(box_size)));
  float t0, t1;
  if (!is_hit && hit_box(ray, rendered_min - margin, rendered_max + margin, t0, t1)) error_bound = 1.0;
#endif
  out_color = collected;
#if STATISTICS
#if EARLY_TERMINATION
  if (TERMINATED) error_bound += transmittance;
#endif
  counts.w |= floatBitsToUint(clamp(error_bound, 0.0, 1.0));
  out_counts = counts;
#endif
}
