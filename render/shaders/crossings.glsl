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

#if PEAK_LIST && SEVERAL_PEAKS
// The peaks that are crossed between two knots and not taken yet: bit k is that of the k-th value, by `crosses`.
struct Crossed {
  int left;
  bool rising;
};

Crossed crossed_between(float before, Knot a, Knot b) {
  vec4 v = few_peaks;
  ivec4 above_a = ivec4(greaterThan(vec4(a.value), v)), on_a = ivec4(equal(vec4(a.value), v));
  ivec4 above_b = ivec4(greaterThan(vec4(b.value), v)), on_b = ivec4(equal(vec4(b.value), v));
  ivec4 inside_a = above_a | (on_a & ivec4(greaterThanEqual(vec4(before), v)));
  ivec4 inside_b = above_b | (on_b & (above_a | on_a));
  ivec4 bits = (inside_a ^ inside_b) << ivec4(0, 1, 2, 3);
  return Crossed(bits.x | bits.y | bits.z | bits.w, b.value >= a.value);
}

bool any_left(Crossed c) { return c.left != 0; }

// The next one in the order in which they are met.
Peak take(inout Crossed c) {
  int k = c.rising ? findLSB(c.left) : findMSB(c.left);
  c.left &= ~(1 << k);
  return peaks[k];
}
#else
// The peaks that may be crossed between two knots, in the order in which they would be met; the k-th is the next one
// that is. Where no step reaches two surfaces there is one candidate.
struct Crossed {
  uint first, count, k;
  bool rising;
  float before, a, b;
};

Peak candidate(Crossed c) {
#if SEVERAL_PEAKS
  return peaks[c.first + (c.rising ? c.k : c.count - 1u - c.k)];
#else
  return peaks[c.first];
#endif
}

void skip_uncrossed(inout Crossed c) {
#if SEVERAL_PEAKS
  while (c.k < c.count && !crosses(candidate(c).value, c.before, c.a, c.b)) ++c.k;
#else
  if (c.k < c.count && !crosses(candidate(c).value, c.before, c.a, c.b)) ++c.k;
#endif
}

Crossed crossed_between(float before, Knot a, Knot b) {
  Crossed c;
  find_candidates(min(a.value, b.value), max(a.value, b.value), c.first, c.count);
  c.k = 0u;
  c.rising = b.value >= a.value;
  c.before = before;
  c.a = a.value;
  c.b = b.value;
  skip_uncrossed(c);
  return c;
}

bool any_left(Crossed c) { return c.k < c.count; }

Peak take(inout Crossed c) {
  Peak peak = candidate(c);
  ++c.k;
  skip_uncrossed(c);
  return peak;
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
  Crossed crossed = crossed_between(before, a, b);
  int found = 0;
  bool again;
  do {
    if (any_left(crossed)) {
      Peak peak = take(crossed);
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
    }
    again = any_left(crossed) && !IS_FULL(found);
#if STATISTICS
    while (!again && any_left(crossed)) {
      take(crossed);
      COUNT_LEFT_OUT;
    }
#endif
#if EXTREMA
    if (!again && parts_left) {
      parts_left = false;
      if (found > 0) from = b;
      before = a.value;
      a = b;
      b = now.b;
      crossed = crossed_between(before, a, b);
      again = any_left(crossed) && !IS_FULL(found);
#if PREINTEGRATED && DVR && SPLIT
      if (found > 0 || again) composite_until(ray, now, from, a, found == 0, DVR_LIGHT(a.t));
#endif
    }
#endif
  } while (again);
  before = a.value;
  return found > 0;
}
