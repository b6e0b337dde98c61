// A march that finds the peaks between its samples. The inner loop runs while nothing is crossed and holds as little
// as a march without peaks; a step that may cross one leaves it. (Where some lanes of a SIMD group take a branch, all
// of them pay for it: this way they pay once a crossing, not once a step.)

#if DVR
// Material of the sample at t, where the surfaces' field has this value: shaded colour, extinction.
vec4 material_at(Ray ray, float t, float value) {
  vec4 material = classify(DVR_VALUE(value, at(ray, t)));
  return vec4(material.rgb * DVR_LIGHT(t), material.a);
}
#endif

#if DVR && SPLIT
// The part of the ray that is not composited yet begins at `done`, in the segment of a sample of this material.
float done;
vec4 sample_material;

// Composites up to a crossing: the piece that holds the sample with the sample's material, to the end of its segment;
// the rest, or a piece between two crossings, with the TF at its middle, on the line between its two knots. No piece
// goes beyond the last segment's end.
void composite_until_hit(Ray ray, Knot from, Knot hit, bool is_first, float boundary, float last_end,
                         float light_at_hit) {
  if (is_first) {
    float end = min(boundary, hit.t);
    composite(sample_material.rgb, opacity_of(sample_material.a * max(end - done, 0.0)));
    done = max(done, end);
  }
  float end = min(hit.t, last_end);
  float size = max(end - done, 0.0);
  float place = clamp((end - 0.5 * size - from.t) / max(hit.t - from.t, 1.0e-30), 0.0, 1.0);
  vec4 material = classify(DVR_VALUE(mix(from.value, hit.value, place), at(ray, end - 0.5 * size)));
  composite(material.rgb * light_at_hit, opacity_of(material.a * size));
  done = max(done, end);
}
#endif

// Two samples in a row, with what is around them: the values of the sample before and the one after, `boundary`, where
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
      composite_until_hit(ray, from, hit, found == 0, now.boundary, now.last_end, light_at_hit);
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
    }
#endif
  } while (again);
  before = a.value;
  return found > 0;
}

// The inner loop composites whole segments. A crossing cuts its segment; the next sample's piece then begins at the
// cut. Behind the last sample the exit takes what is left. All that outlives the inner loop is carried by it: Mesa
// 22.3's llvmpipe takes other values that were computed in a loop from its last lane.
void march(Ray ray, Sampling s, int first, int last) {
  // Take up the march at the knot before the first interval; f0..f3 are the values of four samples in a row
  float t = sample_at(s, first - 1);
  float f1 = field(at(ray, t));
  float f2 = field(at(ray, sample_at(s, first)));
  float f0 = first > 0 ? field(at(ray, sample_at(s, first - 2))) : f1;  // at the entry nothing is known of before
  float f3 = f2;
  if (first < s.n) f3 = field(at(ray, sample_at(s, first + 1)));
  float next_piece = size_at(s, first);  // of the ray, that the sample after `a` stands for
  int cleared = -1;                      // the interval whose crossings were composited
#if DVR && SPLIT
  float cut = first > 0 ? t : boundary_at(s, 0);  // where the piece of the sample `cut_sample` begins
  int cut_sample = first - 1;
  vec4 material = first > 0 ? material_at(ray, t, f1) : vec4(0.0);
  float piece = first > 0 ? boundary_at(s, first) - t : 0.0;  // a run before this one ended at the sample
#endif

  int i = first;
  for (;;) {
    while (i < last) {
      if (may_cross(least_between(f0, f1, f2, f3), most_between(f0, f1, f2, f3)) && i != cleared) break;
#if DVR && SPLIT
      composite(material.rgb, opacity_of(material.a * piece));
      material = material_at(ray, sample_at(s, i), f2);
      piece = next_piece;
      if (i < s.n) COUNT_DVR_SAMPLE;
#elif DVR
      vec4 material = material_at(ray, sample_at(s, i), f2);
      composite(material.rgb, opacity_of(i < s.n ? material.a * next_piece : 0.0));
      if (i < s.n && next_piece > 0.0) COUNT_DVR_SAMPLE;
#endif
      f0 = f1;
      f1 = f2;
      f2 = f3;
      ++i;
      next_piece = size_at(s, i);
      if (i < s.n) f3 = field(at(ray, sample_at(s, i + 1)));
      if (TERMINATED) i = last;
    }
    if (i >= last) break;

    Knot a = Knot(sample_at(s, i - 1), f1), b = Knot(sample_at(s, i), f2);
    float boundary = boundary_at(s, i), last_end = boundary_at(s, s.n);
#if DVR && SPLIT
    done = cut_sample == i - 1 ? cut : boundary_at(s, i - 1);
    sample_material = material;
#endif
    bool crossed = composite_interval(ray, Interval(a, b, i == 0 ? f2 : f0, f3, boundary, last_end, i == 0), f1);
    cleared = i;
    if (crossed) {
#if DVR && SPLIT
      piece = 0.0;
      cut = done;
      cut_sample = i;
      next_piece = min(boundary_at(s, i + 1), last_end) - done;
#elif EXCLUSIVE
      next_piece = 0.0;
#endif
      if (TERMINATED) i = last;
    }
  }
#if DVR && SPLIT && RUNS
  // A run that ends before the ray does ends at a sample; the next one begins there
  if (last <= s.n && !TERMINATED) {
    float begin = cut_sample == last - 1 ? cut : boundary_at(s, last - 1);
    composite(material.rgb, opacity_of(material.a * (middle_at(s, last - 1) - begin)));
  }
#endif
#if DVR && SPLIT
  if (cut_sample == s.n) composite(material.rgb, opacity_of(material.a * piece));
#endif
}
