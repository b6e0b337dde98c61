// Where a span's samples lie (Steneteg et al., Listings 1 to 4, in world units). A sample stands for a segment of dt
// about it. By default the segments share the span out evenly, from its entry to its exit: at least one
// (entry_exit_corner), or in a span shorter than a step none (ENTRY_EXIT). ENTRY and EYE take whole steps, counted from
// the entry or the eye, and those samples that lie in the span: so the segments end up to half a step before the exit
// or stick out as far beyond it, and with EYE also at the entry.

// Pre-integration has a segment in every span.
#define LEAST_SEGMENTS PREINTEGRATED

uniform float step_length;  // in units of the smallest spacing

Sampling equal_segments(Span span, int n, float dt, float begin) {
  return Sampling(span, n, begin, dt, begin + dt, 0.0, begin + float(n) * dt);
}

Sampling sample_span(Ray ray, Span span) {
  float size = span.exit - span.enter;
#if PLACEMENT_EYE
  float first = (1.0 - fract((span.enter - ray.eye) / step_length)) * step_length;
  return equal_segments(span, max(LEAST_SEGMENTS, int(ceil((size - first) / step_length))), step_length,
                        span.enter + first - 0.5 * step_length);
#elif PLACEMENT_ENTRY
  return equal_segments(span, max(LEAST_SEGMENTS, int(ceil(size / step_length - 0.5))), step_length, span.enter);
#elif PLACEMENT_ENTRY_EXIT
  int n = max(LEAST_SEGMENTS, int(floor(size / step_length)));
  return equal_segments(span, n, size / float(max(n, 1)), span.enter);
#elif PLACEMENT_ENTRY_EXIT_CORNER
  int n = max(1, int(ceil(size / step_length)));
  return equal_segments(span, n, size / float(n), span.enter);
#else
#error The placement is not known here.
#endif
}
