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

// Composites up to a crossing: the part that holds the sample with the sample's material, to the end of its segment;
// the rest, or a part between two crossings, with the TF at its middle, on the line between its two knots. No part
// goes beyond the last segment's end.
void composite_until(Ray ray, Interval now, Knot from, Knot hit, bool is_first, float light_at_hit) {
  if (is_first) {
    float end = min(now.boundary, hit.t);
    composite(sample_material.rgb, opacity_of(sample_material.a * max(end - done, 0.0)));
    done = max(done, end);
  }
  float end = min(hit.t, now.last_end);
  float size = max(end - done, 0.0);
  float place = clamp((end - 0.5 * size - from.t) / max(hit.t - from.t, 1.0e-30), 0.0, 1.0);
  vec4 material = classify(DVR_VALUE(mix(from.value, hit.value, place), at(ray, end - 0.5 * size)));
  composite(material.rgb * light_at_hit, opacity_of(material.a * size));
  done = max(done, end);
}
#endif

// The inner loop composites whole segments. A crossing cuts its segment; the next sample's part then begins at the
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
  float next_part = size_at(s, first);  // of the ray, that the sample after `a` stands for
  int cleared = -1;                      // the interval whose crossings were composited
#if DVR && SPLIT
  float cut = first > 0 ? t : boundary_at(s, 0);  // where the part of the sample `cut_sample` begins
  int cut_sample = first - 1;
  vec4 material = vec4(0.0);
  float part = 0.0;
#if LONG_RAYS
  if (first > 0) {  // the pass before this one ended at the sample
    material = material_at(ray, t, f1);
    part = boundary_at(s, first) - t;
  }
#endif
#endif

  int i = first;
  for (;;) {
    while (i < last) {
      if (may_cross(least_between(f0, f1, f2, f3), most_between(f0, f1, f2, f3)) && i != cleared) break;
#if DVR && SPLIT
      composite(material.rgb, opacity_of(material.a * part));
      material = material_at(ray, sample_at(s, i), f2);
      part = next_part;
      if (i < s.n) COUNT_DVR_SAMPLE;
#elif DVR
      vec4 material = material_at(ray, sample_at(s, i), f2);
      composite(material.rgb, opacity_of(i < s.n ? material.a * next_part : 0.0));
      if (i < s.n && next_part > 0.0) COUNT_DVR_SAMPLE;
#endif
      f0 = f1;
      f1 = f2;
      f2 = f3;
      ++i;
      next_part = size_at(s, i);
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
      part = 0.0;
      cut = done;
      cut_sample = i;
      next_part = min(boundary_at(s, i + 1), last_end) - done;
#elif EXCLUSIVE
      next_part = 0.0;
#endif
      if (TERMINATED) i = last;
    }
  }
#if DVR && SPLIT && LONG_RAYS
  // A pass that ends before the ray does ends at a sample; the next one begins there
  if (last <= s.n && !TERMINATED) {
    float begin = cut_sample == last - 1 ? cut : boundary_at(s, last - 1);
    composite(material.rgb, opacity_of(material.a * (middle_at(s, last - 1) - begin)));
  }
#endif
#if DVR && SPLIT
  if (cut_sample == s.n) composite(material.rgb, opacity_of(material.a * part));
#endif
}
