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
// The part of the ray that is not composited yet begins at `done`. The piece of a segment that holds its sample
// takes the sample's material; a piece that a crossing cut off takes the TF at its middle, between its two knots.
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

// Composites the crossings between knots a and b in their order, with the pieces of the segments between them;
// `boundary` is the end of a's segment. Whether there was one.
bool composite_crossings(Ray ray, float before, Knot a, Knot b, float boundary) {
  int found = 0;
  Knot from = a;
  bool rising = b.value >= a.value;
  uint first, count;
  find_candidates(a.value, b.value, first, count);
  for (uint k = 0u; k < count && found < max_peaks; ++k) {
    Peak peak = peaks[first + (rising ? k : count - 1u - k)];
    if (!crosses(peak.value, before, a.value, b.value)) continue;
    Knot hit = Knot(solve(ray, from, b, peak.value), peak.value);
#if DVR && SPLIT
    composite_until(ray, min(boundary, hit.t), from, hit, found == 0);
    composite_until(ray, hit.t, from, hit, false);
#endif
    composite(peak.color_opacity.rgb * LIGHT(hit.t), peak.color_opacity.a);
    COUNT_CROSSING;
    from = hit;
    ++found;
  }
#if DVR && SPLIT
  composite_until(ray, boundary, from, b, found == 0);
#endif
  return found > 0;
}

void march(Ray ray, Sampling s, int first, int last) {
  // Take up the march at the knot before the first interval
  Knot a = Knot(sample_at(s, first - 1), 0.0);
  a.value = field(at(ray, a.t));
  float before = first > 0 ? field(at(ray, sample_at(s, first - 2))) : 0.0;
#if DVR && SPLIT
  done = a.t;
  sample_material = first > 0 ? material_at(ray, a.t, a.value) : vec4(0.0);
#endif

  for (int i = first; i < last; ++i) {
    Knot b;
    float boundary;
    bool leaves = false;
    for (;;) {
      b.t = sample_at(s, i);
      b.value = field(at(ray, b.t));
      boundary = s.span.enter + float(i) * s.dt;
      leaves = may_cross(a.value, b.value);
      if (leaves) break;
#if DVR && SPLIT
      composite(sample_material.rgb, opacity_of(sample_material.a * (boundary - done)));
      done = boundary;
      sample_material = material_at(ray, b.t, b.value);
#elif DVR
      vec4 material = material_at(ray, b.t, b.value);
      composite(material.rgb, opacity_of(i < s.n ? material.a * s.dt : 0.0));
#endif
      before = a.value;
      a = b;
      if (++i >= last || TERMINATED) break;
    }
    if (!leaves) break;

    if (i == 0) before = b.value;
    bool crossed = composite_crossings(ray, before, a, b, boundary);
#if DVR && SPLIT
    sample_material = material_at(ray, b.t, b.value);
#elif DVR
    vec4 material = material_at(ray, b.t, b.value);
    bool is_sample = i < s.n && !(EXCLUSIVE != 0 && crossed);
    composite(material.rgb, opacity_of(is_sample ? material.a * s.dt : 0.0));
#endif
    before = a.value;
    a = b;
    if (TERMINATED) break;
  }
#if DVR && SPLIT
  // A pass that ends before the ray does ends at a sample; the next one begins there
  if (!TERMINATED) composite_until(ray, a.t, a, a, true);
#endif
#if STATISTICS && DVR
  counts.y += uint(max(0, min(last, s.n) - first));
#endif
}
