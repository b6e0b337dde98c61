// The crossings of peaks between two knots of a march in a row, and what lies before each of them.

#include "peaks.glsl"
#include "compositing.glsl"
#include "shading.glsl"

// Two knots in a row, with what is around them: the values of the knot before and the one after, `boundary`, where
// a's segment ends, and where the last segment of all does.
struct Interval {
  Knot a, b;
  float before, after, boundary, last_end;
  bool is_first;  // of the span: nothing is known of the field before
};

// The least and the greatest value that the field can have between two samples of a row of four. The lines that lead
// to them from outside bound it, where it is convex there: also an extremum between the samples.
#if EXTREMA
float least_between(float f0, float f1, float f2, float f3) {
  return min(min(f1, f2), max(2.0 * f1 - f0, 2.0 * f2 - f3));
}
float most_between(float f0, float f1, float f2, float f3) {
  return max(max(f1, f2), min(2.0 * f1 - f0, 2.0 * f2 - f3));
}
#else
float least_between(float f0, float f1, float f2, float f3) { return min(f1, f2); }
float most_between(float f0, float f1, float f2, float f3) { return max(f1, f2); }
#endif

#if DVR && SPLIT
// The march's: composites the ray up to a knot - a crossing of this interval, the first or a later one, or with
// pre-integration an extremum - from `from`, the knot before it.
void composite_until(Ray ray, Interval now, Knot from, Knot knot, bool is_first, float light_at_knot);
#endif

#if EXTREMA
// Where the lines that lead to a from before and to b from after meet, if that is between them and comes out beyond
// both: the place of a cusp (trilinear fields have them at the cells' faces), and nearly that of a smooth extremum.
bool find_extremum(Ray ray, Interval now, out Knot extremum) {
  float rise_before = now.a.value - now.before, rise_after = now.after - now.b.value;
  float place = (now.b.value - now.a.value - rise_after) / (rise_before - rise_after);
  bool turns = rise_before < 0.0 ? rise_after > 0.0 : rise_before > 0.0 && rise_after < 0.0;  // no product: it underflows
  if (now.is_first || !turns || !(place > 0.0 && place < 1.0)) return false;
#if PEAK_TABLE
  // What is found must not depend on how far the table's bins reach beyond their peaks
  if (!holds_peak(least_between(now.before, now.a.value, now.b.value, now.after),
                  most_between(now.before, now.a.value, now.b.value, now.after)))
    return false;
#endif
  extremum.t = mix(now.a.t, now.b.t, place);
  extremum.value = field(at(ray, extremum.t));
  return extremum.value > max(now.a.value, now.b.value) || extremum.value < min(now.a.value, now.b.value);
}
#endif

// The peaks that may be crossed between two knots.
struct Candidates {
  uint first, count;
  bool rising;
};

Candidates candidates_between(Knot a, Knot b) {
  Candidates c;
  find_candidates(min(a.value, b.value), max(a.value, b.value), c.first, c.count);
  c.rising = b.value >= a.value;
  return c;
}

// The k-th in the order in which they would be met; the first one from the k-th that is crossed, or their count when
// there is none. Where no step reaches two surfaces there is one candidate.
#if SEVERAL_PEAKS
Peak peak_at(Candidates c, uint k) { return peaks[c.first + (c.rising ? k : c.count - 1u - k)]; }

uint next_crossed(Candidates c, uint k, float before, Knot a, Knot b) {
  while (k < c.count && !crosses(peak_at(c, k).value, before, a.value, b.value)) ++k;
  return k;
}
#else
Peak peak_at(Candidates c, uint k) { return peaks[c.first]; }

uint next_crossed(Candidates c, uint k, float before, Knot a, Knot b) {
  return k < c.count && crosses(peaks[c.first].value, before, a.value, b.value) ? k : c.count;
}
#endif

// Composites all crossings of an interval in their order, each with what lies before it. A surface that is entered and
// left again within one step shows only at an extremum between the samples, which makes two parts of the interval.
// Whether there was a crossing; `before` is then the value before b. (On SIMD hardware a round of the loop costs all
// lanes the same: there is one a crossing, and one where there is none.)
bool composite_interval(Ray ray, Interval now, out float before) {
  Knot from = now.a, a = now.a, b = now.b;
  bool parts_left = false;
#if EXTREMA
  parts_left = find_extremum(ray, now, b);
  if (!parts_left) b = now.b;
#endif
  before = now.before;
  Candidates candidates = candidates_between(a, b);
  uint k = next_crossed(candidates, 0u, before, a, b);
  int found = 0;
  bool again;
  do {
    if (k < candidates.count) {
      Peak peak = peak_at(candidates, k);
      Knot bracket = a;
      if (from.t > a.t) bracket = from;
      Knot hit = Knot(solve(ray, bracket, b, peak.value), peak.value);
      float light_at_hit = LIGHT(hit.t);
#if DVR && SPLIT
      composite_until(ray, now, from, hit, found == 0, light_at_hit);
#endif
      composite(peak.color_opacity.rgb * light_at_hit, peak.color_opacity.a);
      COUNT_CROSSING;
      from = hit;
      ++found;
      k = next_crossed(candidates, k + 1u, before, a, b);
    }
    again = k < candidates.count && !IS_FULL(found);
#if STATISTICS
    for (uint left = k; !again && left < candidates.count; left = next_crossed(candidates, left + 1u, before, a, b))
      COUNT_LEFT_OUT;
#endif
#if EXTREMA
    if (!again && parts_left) {
      parts_left = false;
      if (found > 0) from = b;
      before = a.value;
      a = b;
      b = now.b;
      candidates = candidates_between(a, b);
      k = next_crossed(candidates, 0u, before, a, b);
      again = k < candidates.count && !IS_FULL(found);
#if PREINTEGRATED && DVR && SPLIT
      if (found > 0 || again) composite_until(ray, now, from, a, found == 0, DVR_LIGHT(a.t));
#endif
    }
#endif
  } while (again);
  before = a.value;
  return found > 0;
}
