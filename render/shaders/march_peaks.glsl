// A march that finds the peaks between its samples. The inner loop runs while nothing is crossed and holds as little
// as a march without peaks; a step that may cross one leaves it. (Where some lanes of a SIMD group take a branch, all
// of them pay for it: this way they pay once a crossing, not once a step.)

#if DVR
// Material of the sample at t: shaded colour, extinction.
vec4 material_at(Ray ray, float t, float value) {
  vec4 material = classify(value);
  return vec4(material.rgb * LIGHT(t), material.a);
}
#endif

#if DVR && SPLIT
// What is left of the current segment begins at `done`; the piece of it that holds its sample takes the sample's
// material, and one that a crossing cut off takes the TF at its middle, between its two knots.
float done;
vec4 sample_material;

void composite_until(Ray ray, float t, Knot a, Knot b, bool holds_sample) {
  float size = max(t - done, 0.0), middle = done + 0.5 * size;
  vec4 material = sample_material;
  if (!holds_sample && size > 0.0)
    material = material_at(ray, middle, mix(a.value, b.value, (middle - a.t) / (b.t - a.t)));
  composite(material.rgb, opacity_of(material.a * size));
  done = max(done, t);
}
#endif

// Two samples in a row, with what is around them: the values of the sample before and the one after, and `boundary`,
// where a's segment ends.
struct Interval {
  Knot a, b;
  float before, after, boundary;
};

#if EXTREMA
// Where the lines that lead to a from before and to b from after meet, if that is between them and comes out beyond
// both: the place of a cusp (trilinear fields have them at the cells' faces), and nearly that of a smooth extremum.
bool find_extremum(Ray ray, Interval now, out Knot extremum) {
  float rise_before = now.a.value - now.before, rise_after = now.after - now.b.value;
  float place = (now.b.value - now.a.value - rise_after) / (rise_before - rise_after);
  if (!(rise_before * rise_after < 0.0 && place > 0.0 && place < 1.0)) return false;
  extremum.t = mix(now.a.t, now.b.t, place);
  extremum.value = field(at(ray, extremum.t));
  return extremum.value > max(now.a.value, now.b.value) || extremum.value < min(now.a.value, now.b.value);
}
#endif

// Composites the crossings between knots a and b of an interval in their order, with the pieces of the segments
// between them. `from` is the last knot before them, `found` counts the crossings.
void composite_crossings(Ray ray, Interval interval, float before, Knot a, Knot b, inout Knot from, inout int found) {
  bool rising = b.value >= a.value;
  uint first, count;
  find_candidates(min(a.value, b.value), max(a.value, b.value), first, count);
  for (uint k = 0u; k < count && found < max_peaks; ++k) {
    Peak peak = peaks[first + (rising ? k : count - 1u - k)];
    if (!crosses(peak.value, before, a.value, b.value)) continue;
    Knot bracket = a;
    if (from.t > a.t) bracket = from;
    Knot hit = Knot(solve(ray, bracket, b, peak.value), peak.value);
#if DVR && SPLIT
    composite_until(ray, min(interval.boundary, hit.t), from, hit, found == 0);
    composite_until(ray, hit.t, from, hit, false);
#endif
    composite(peak.color_opacity.rgb * LIGHT(hit.t), peak.color_opacity.a);
    COUNT_CROSSING;
    from = hit;
    ++found;
  }
}

// All crossings of an interval, up to the end of its first sample's segment. A surface that is entered and left again
// within one step shows only at an extremum between the samples. Whether there was a crossing; `before` is then the
// value before b.
bool composite_interval(Ray ray, Interval interval, out float before) {
  Knot from = interval.a, a = interval.a, middle = interval.b;
  int found = 0, parts = 1;
  before = interval.before;
#if EXTREMA
  Knot extremum;
  if (find_extremum(ray, interval, extremum)) {
    middle = extremum;
    parts = 2;
  }
#endif
  for (int part = 0; part < parts; ++part) {
    composite_crossings(ray, interval, before, a, middle, from, found);
#if DVR && SPLIT
    if (found > 0) {
      composite_until(ray, min(interval.boundary, middle.t), from, middle, false);
      if (part + 1 < parts) composite_until(ray, middle.t, from, middle, false);
    }
#endif
    if (found > 0) from = middle;
    before = a.value;
    a = middle;
    middle = interval.b;
  }
#if DVR && SPLIT
  composite_until(ray, interval.boundary, interval.a, interval.b, found == 0);
#endif
  return found > 0;
}

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

// The inner loop composites whole segments; where a crossing, or the begin of a pass, has cut one, the rest of it is
// kept with `cut`, its interval, and the inner loop is given a thinner material instead.
// All that outlives the inner loop is carried by it: Mesa 22.3's llvmpipe takes other values that were computed in a
// loop from the last lane to leave it.
void march(Ray ray, Sampling s, int first, int last) {
  // Take up the march at the knot before the first interval; f0..f3 are the values of four samples in a row
  float t = sample_at(s, first - 1);
  float f1 = field(at(ray, t));
  float f2 = field(at(ray, sample_at(s, first)));
  float f0 = first > 0 ? field(at(ray, sample_at(s, first - 2))) : f2;
  float f3 = f2;
  if (first < s.n) f3 = field(at(ray, sample_at(s, first + 1)));
#if DVR && SPLIT
  vec4 material = first > 0 ? material_at(ray, t, f1) : vec4(0.0);
  float rest_begin = t, whole_extinction = material.a;
  int cut = first - 1;
  material.a *= 0.5;
#endif

  int i = first;
  for (;;) {
    while (i < last) {
      if (may_cross(least_between(f0, f1, f2, f3), most_between(f0, f1, f2, f3))) break;
#if DVR && SPLIT
      composite(material.rgb, opacity_of(material.a * s.dt));
      material = material_at(ray, s.span.enter + (float(i) + 0.5) * s.dt, f2);
#elif DVR
      vec4 material = material_at(ray, s.span.enter + (float(i) + 0.5) * s.dt, f2);
      composite(material.rgb, opacity_of(i < s.n ? material.a * s.dt : 0.0));
#endif
      f0 = f1;
      f1 = f2;
      f2 = f3;
      ++i;
      if (i < s.n) f3 = field(at(ray, sample_at(s, i + 1)));
      if (TERMINATED) i = last;
    }
    if (i >= last) break;

    Knot a = Knot(sample_at(s, i - 1), f1), b = Knot(sample_at(s, i), f2);
    float boundary = s.span.enter + float(i) * s.dt;
#if DVR && SPLIT
    bool is_whole = cut != i - 1;
    done = is_whole ? boundary - s.dt : rest_begin;
    sample_material = vec4(material.rgb, is_whole ? material.a : whole_extinction);
#endif
    bool crossed = composite_interval(ray, Interval(a, b, f0, f3, boundary), f0);
#if DVR && SPLIT
    material = material_at(ray, b.t, f2);
    rest_begin = done;
    whole_extinction = material.a;
    cut = i;
    material.a *= (boundary + s.dt - done) / s.dt;
#elif DVR
    vec4 material = material_at(ray, b.t, f2);
    bool is_sample = i < s.n && !(EXCLUSIVE != 0 && crossed);
    composite(material.rgb, opacity_of(is_sample ? material.a * s.dt : 0.0));
#endif
    f1 = f2;
    f2 = f3;
    ++i;
    if (i < s.n) f3 = field(at(ray, sample_at(s, i + 1)));
    if (TERMINATED) i = last;
  }
#if DVR && SPLIT
  // A pass that ends before the ray does ends at a sample; the next one begins there
  if (last <= s.n && !TERMINATED) {
    t = sample_at(s, last - 1);
    float size = cut == last - 1 ? t - rest_begin : 0.5 * s.dt;
    composite(material.rgb, opacity_of((cut == last - 1 ? whole_extinction : material.a) * max(size, 0.0)));
  }
#endif
#if STATISTICS && DVR
  counts.y += uint(max(0, min(last, s.n) - first));
#endif
}
