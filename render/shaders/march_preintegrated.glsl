// A march of pre-integrated segments. It evaluates the field at their ends, so that n segments take n + 1 values, and
// runs from entry to exit with every placement: these differ in where the ends between lie. A segment is shaded in
// its middle; the paper shades it at its end, where the light is half a step off.

#include "sampling.glsl"
#include "preintegration.glsl"
#include "shading.glsl"

// The i-th segment's beginning; for i = n, the exit.
float end_at(Sampling s, int i) {
  return i <= 0 ? s.span.enter : i < s.n ? clamp(boundary_at(s, i), s.span.enter, s.span.exit) : s.span.exit;
}

#if !PEAKS

void march(Ray ray, Sampling s, int first, int last) {
  float begin = end_at(s, first);
  Place front = place_of(dvr_field(at(ray, begin)));
  for (int i = first; i < last; ++i) {
    float end = end_at(s, i + 1);
    Place back = place_of(dvr_field(at(ray, end)));
    COUNT_DVR_SAMPLE;
    composite_segment(front, back, end - begin, DVR_LIGHT(0.5 * (begin + end)));
    begin = end;
    front = back;
    if (TERMINATED) break;
  }
}

#else

// With peaks, in the same two loops as march_peaks.glsl: an interval is a segment here.

Place place_at(Ray ray, Knot knot) { return place_of(DVR_VALUE(knot.value, at(ray, knot.t))); }

#if SPLIT
// A segment that a crossing cuts is composited up to here.
float reached;
Place reached_place;

void composite_until(Ray ray, Interval now, Knot from, Knot knot, bool is_first, float light_at_knot) {
  Place place = place_at(ray, knot);
  composite_segment(reached_place, place, knot.t - reached, light_at_knot);
  reached = knot.t;
  reached_place = place;
}
#endif

void march(Ray ray, Sampling s, int first, int last) {
  // f0..f3 are the values of four ends in a row; at the entry nothing is known of before
  float f1 = field(at(ray, end_at(s, first)));
  float f2 = field(at(ray, end_at(s, first + 1)));
  float f0 = first > 0 ? field(at(ray, end_at(s, first - 1))) : f1;
  float f3 = f2;
  if (first + 1 < s.n) f3 = field(at(ray, end_at(s, first + 2)));
  Place front = place_at(ray, Knot(end_at(s, first), f1));
  int cleared = -1;      // the segment whose crossings were composited
  bool is_left = true;   // whether the next segment still is to be
  int i = first;
  for (;;) {
    while (i < last) {
      if (i != cleared && may_cross(least_between(f0, f1, f2, f3), most_between(f0, f1, f2, f3))) break;
      float begin = end_at(s, i), end = end_at(s, i + 1);
      Place back = place_at(ray, Knot(end, f2));
      if (is_left) {
        COUNT_DVR_SAMPLE;
        composite_segment(front, back, end - begin, DVR_LIGHT(0.5 * (begin + end)));
      }
      is_left = true;
      front = back;
      f0 = f1;
      f1 = f2;
      f2 = f3;
      ++i;
      if (i + 1 < s.n) f3 = field(at(ray, end_at(s, i + 2)));
      if (TERMINATED) i = last;
    }
    if (i >= last) break;

    Knot a = Knot(end_at(s, i), f1), b = Knot(end_at(s, i + 1), f2);
    Interval now = Interval(a, b, i == 0 ? f2 : f0, f3, b.t, b.t, i == 0);
#if SPLIT
    reached = a.t;
    reached_place = front;
#endif
    bool crossed = composite_interval(ray, now, f1);
    cleared = i;
    if (crossed) {
#if SPLIT
      COUNT_DVR_SAMPLE;
      composite_until(ray, now, a, b, false, DVR_LIGHT(0.5 * (reached + b.t)));
      is_left = false;
#elif EXCLUSIVE
      is_left = false;
#endif
      if (TERMINATED) i = last;
    }
  }
}
#endif
