// Where a span's samples lie (Steneteg et al., Listings 1 to 4, in world units). A sample stands for a segment of dt
// about it. By default the segments share the span out evenly, from its entry to its exit: at least one
// (entry_exit_corner), or in a span shorter than a step none (ENTRY_EXIT). ENTRY and EYE take whole steps, counted from
// the entry or the eye, and those samples that lie in the span: so the segments end up to half a step before the exit
// or stick out as far beyond it, and with EYE also at the entry.

// Pre-integration has a segment in every span.
#define LEAST_SEGMENTS PREINTEGRATED

uniform float step_length;  // in units of the smallest spacing

Sampling equal_segments(Span span, int n, float dt, float begin) {
  precise float second = begin + dt, end = begin + float(n) * dt;
  return Sampling(span, n, begin, dt, second, 0.0, end);
}

Sampling sample_span(Ray ray, Span span) {
  precise float size = span.exit - span.enter, steps = size / step_length;
#if PLACEMENT_EYE
  precise float first = (1.0 - fract((span.enter - ray.eye) / step_length)) * step_length;
  precise float begin = span.enter + first - 0.5 * step_length, left = (size - first) / step_length;
  return equal_segments(span, max(LEAST_SEGMENTS, int(ceil(left))), step_length, begin);
#elif PLACEMENT_ENTRY
  return equal_segments(span, max(LEAST_SEGMENTS, int(ceil(steps - 0.5))), step_length, span.enter);
#elif PLACEMENT_ENTRY_EXIT
  int n = max(LEAST_SEGMENTS, int(floor(steps)));
  precise float dt = size / float(max(n, 1));
  return equal_segments(span, n, dt, span.enter);
#elif PLACEMENT_ENTRY_EXIT_CORNER
  int n = max(1, int(ceil(steps)));
  precise float dt = size / float(n);
  return equal_segments(span, n, dt, span.enter);
#else
#error The placement is not known here.
#endif
}
