// Where a span's samples lie. A sample stands for a segment of the ray, and lies in the segment's middle. The segments
// are equal (placement.glsl), or they grow (differential.glsl); where the sampling is adaptive, several segments are
// joined into one.

#include "spans.glsl"

struct Sampling {
  Span span;
  int n;         // the number of segments
  float begin;   // where the first segment begins
  float dt;      // the length of a segment; where lengths vary, that of the second (FOOTPRINT: what that is a share of)
  float second;  // where the second segment begins
  float growth;  // how much longer a segment is than the one before (FOOTPRINT: log2 of how many times as long)
  float end;     // where the last segment ends
};

#define VARYING_STEPS (DIFFERENTIAL || FOOTPRINT || ADAPTIVE)

#if VARYING_STEPS

// length_of is the length of j segments from the second one on; count_of is the number of segments that have a given
// length. Both are closed forms, counted from within the span: nothing is added up, so that short steps far from the eye
// lose no digits.
#if FOOTPRINT
float length_of(Sampling s, float j) {
  precise float size = s.dt * (exp2(s.growth * j) - 1.0);
  return size;
}
float count_of(Sampling s, float size) { return log2(1.0 + size / s.dt) / s.growth; }
#else
float length_of(Sampling s, float j) {
  precise float size = j * (s.dt + 0.5 * s.growth * (j - 1.0));
  return size;
}
float count_of(Sampling s, float size) {
  float c = s.dt - 0.5 * s.growth, root = sqrt(c * c + 2.0 * s.growth * size);
  return c > 0.0 ? 2.0 * size / (c + root) : (root - c) / s.growth;
}
#endif

// boundary_at is where the i-th segment begins (for i = n, where the last one ends); size_at is its length, middle_at its
// middle.
float boundary_at(Sampling s, int i) {
  precise float t = s.second + length_of(s, float(i - 1));
  return i <= 0 ? s.begin : i >= s.n ? s.end : min(t, s.end);
}
float size_at(Sampling s, int i) { return boundary_at(s, i + 1) - boundary_at(s, i); }
float middle_at(Sampling s, int i) {
  precise float t = 0.5 * (boundary_at(s, i) + boundary_at(s, i + 1));
  return t;
}

// The index of the segment that holds t, plus the share of the segment that lies before t.
float index_at(Sampling s, float t) {
  return t < s.second ? (t - s.begin) / (s.second - s.begin) : 1.0 + count_of(s, t - s.second);
}

#else

float boundary_at(Sampling s, int i) {
  precise float t = s.begin + float(i) * s.dt;
  return t;
}
float size_at(Sampling s, int i) { return s.dt; }
float middle_at(Sampling s, int i) {
  precise float t = s.begin + (float(i) + 0.5) * s.dt;
  return t;
}
float index_at(Sampling s, float t) { return (t - s.begin) / s.dt; }

#endif

// The place of the i-th sample; -1 is the span's entry, n its exit.
float sample_at(Sampling s, int i) { return i < 0 ? s.span.enter : i < s.n ? middle_at(s, i) : s.span.exit; }

#if DIFFERENTIAL || FOOTPRINT
#include "differential.glsl"
#else
#include "placement.glsl"
#endif

#if ADAPTIVE
// The segments [first, last), joined `multiple` at a time (Knoll et al., eq. 19: the sums of so many steps; the last
// one may be shorter).
Sampling joined(Sampling s, int first, int last, int multiple) {
  int second = min(first + multiple, last);
  float m = float(multiple), steps_before = float(second - 1);
  Sampling part;
  part.n = (last - first + multiple - 1) / multiple;
  part.begin = boundary_at(s, first);
  part.second = boundary_at(s, second);
  part.end = boundary_at(s, last);
  part.span = Span(first == 0 ? s.span.enter : part.begin, last == s.n ? s.span.exit : part.end);
#if FOOTPRINT
  part.dt = s.dt * exp2(s.growth * steps_before);
  part.growth = s.growth * m;
#else
  part.dt = m * (s.dt + s.growth * (steps_before + 0.5 * (m - 1.0)));
  part.growth = s.growth * m * m;
#endif
  return part;
}
#endif
