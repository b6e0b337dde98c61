// A march that finds the peaks between its samples.

#if DVR && SPLIT
// The part of the ray that is not composited yet begins at `done`. The piece of a segment that holds its sample
// takes the sample's material; a piece that a crossing cut off takes the TF at its middle, between its two knots.
float done;
vec4 sample_material;
bool holds_sample;

void composite_until(Ray ray, float t, Knot a, Knot b) {
  if (t <= done) return;
  float middle = 0.5 * (done + t);
  vec4 material = sample_material;
  if (!holds_sample) material = classify(a.value + (b.value - a.value) * ((middle - a.t) / (b.t - a.t)));
  composite(material.rgb * LIGHT(middle), opacity_of(material.a * (t - done)));
  done = t;
  holds_sample = false;
}
#endif

// Composites the crossings between knots a and b in their order; `boundary` is the end of a's segment.
// The number of them.
int composite_crossings(Ray ray, float before, Knot a, Knot b, uint first, uint count, float boundary) {
  int found = 0;
  Knot from = a;
  bool rising = b.value >= a.value;
  for (uint k = 0u; k < count && found < MAX_PEAKS; ++k) {
    Peak peak = peaks[first + (rising ? k : count - 1u - k)];
    if (!crosses(peak.value, before, a.value, b.value)) continue;
    Knot hit = Knot(solve(ray, from, b, peak.value), peak.value);
#if DVR && SPLIT
    if (hit.t > boundary) composite_until(ray, boundary, from, hit);
    composite_until(ray, hit.t, from, hit);
    holds_sample = false;
#endif
    composite(peak.color_opacity.rgb * LIGHT(hit.t), peak.color_opacity.a);
    COUNT_CROSSING;
    from = hit;
    ++found;
  }
#if DVR && SPLIT
  if (found > 0) composite_until(ray, boundary, from, b);
#endif
  return found;
}

void march(Ray ray, Sampling s, int first, int last) {
  // Take up the march at the knot before the first interval
  Knot a;
  a.t = sample_at(s, first - 1);
  a.value = field(at(ray, a.t));
  float before = first > 0 ? field(at(ray, sample_at(s, first - 2))) : 0.0;
#if PEAK_TABLE
  int entry_bin = bin_of(a.value);
#endif
#if DVR && SPLIT
  done = a.t;
  holds_sample = first > 0;
  if (holds_sample) sample_material = classify(a.value);
#endif

  for (int i = first; i < last; ++i) {
    Knot b;
    b.t = sample_at(s, i);
    b.value = field(at(ray, b.t));
    if (i == 0) before = b.value;
    float boundary = s.span.enter + float(i) * s.dt;

#if PEAK_TABLE
    int exit_bin = bin_of(b.value);
    uint run = texelFetch(peak_table, ivec2(entry_bin, exit_bin), 0).r;
    uint first_peak = run & 0xffffu, peak_count = run >> 16;
    entry_bin = exit_bin;
#else
    const uint first_peak = 0u, peak_count = uint(PEAK_COUNT);
#endif
    int found = 0;
    if (peak_count > 0u) found = composite_crossings(ray, before, a, b, first_peak, peak_count, boundary);

#if DVR
    bool is_sample = i < s.n;
    if (is_sample) COUNT_DVR_SAMPLE;
#if SPLIT
    composite_until(ray, boundary, a, b);
    if (is_sample) sample_material = classify(b.value);
    holds_sample = is_sample;
#else
#if EXCLUSIVE
    is_sample = is_sample && found == 0;
#endif
    if (is_sample) {
      vec4 material = classify(b.value);
      composite(material.rgb * LIGHT(b.t), opacity_of(material.a * s.dt));
    }
#endif
#endif
    before = a.value;
    a = b;
    if (TERMINATED) return;
  }
#if DVR && SPLIT
  composite_until(ray, a.t, a, a);  // a pass ends at a sample; the next one begins there
#endif
}
