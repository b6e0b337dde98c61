// Pre-integration: what a segment collects on which the field is linear between its two ends.

#include "compositing.glsl"

#if PREINTEGRATION_TABLE

// Engel's table of front and back value, for one length only (classify/preintegration_table.h).
uniform sampler2D preintegration_table;
uniform vec3 preintegration_min_scale_offset;  // the coordinate of a value is (value - x) * y + z
uniform float preintegrated_length;

// Where a value is in the table.
struct Place {
  float coordinate;
};

Place place_of(float value) {
  vec3 from = preintegration_min_scale_offset;
  return Place((value - from.x) * from.y + from.z);
}

// Composites a segment. A part of one, or the last one before the exit, is not as long as the table's: it takes the
// opacity that its length has, exactly, and the table's colour.
void composite_segment(Place front, Place back, float size, float light) {
  vec4 material = textureLod(preintegration_table, vec2(front.coordinate, back.coordinate), 0.0);
  float alpha = material.a;
  if (abs(size - preintegrated_length) > 1.0e-3 * preintegrated_length)
    alpha = opacity_of(depth_of(alpha) * (size / preintegrated_length));
  composite(material.rgb * (light / max(material.a, 1.0e-30)), alpha);
}

#else

// The TF's antiderivatives over the value, for segments of any length (classify/antiderivatives.h): an entry is a row
// of mean, slope, and the sum of the means before it in two parts. The first and the last are all values beyond.
uniform sampler2D antiderivatives;
uniform vec2 antiderivatives_min_scale;

// Where a value is in the table: in which entry, at x in [0, 1] (in the first x goes down, in the last up, without
// end), and what the entry holds.
struct Place {
  float entry, x;
  vec4 mean, slope, sum_high, sum_low;
};

Place place_of(float value) {
  int last = textureSize(antiderivatives, 0).y - 1;
  float position = (value - antiderivatives_min_scale.x) * antiderivatives_min_scale.y + 1.0;
  float entry = clamp(floor(position), 0.0, float(last));
  int row = int(entry);
  return Place(entry, position - entry, texelFetch(antiderivatives, ivec2(0, row), 0),
               texelFetch(antiderivatives, ivec2(1, row), 0), texelFetch(antiderivatives, ivec2(2, row), 0),
               texelFetch(antiderivatives, ivec2(3, row), 0));
}

// Mean emission and extinction between two values. Apart from the difference of the sums, which the two floats
// keep, only what is positive is added, so that nothing cancels where the values are near each other.
vec4 mean_between(Place a, Place b) {
  float apart = abs(b.entry - a.entry);
  if (apart == 0.0) return a.mean + (0.5 * (a.x + b.x) - 0.5) * a.slope;
  bool rising = b.entry > a.entry;
  float leave = rising ? 1.0 : 0.0;  // where the segment leaves a's entry
  float in_a = abs(leave - a.x), in_b = abs(b.x + leave - 1.0);
  vec4 sum = in_a * (a.mean + 0.5 * (a.x + leave - 1.0) * a.slope) + in_b * (b.mean + 0.5 * (b.x - leave) * b.slope);
  if (apart > 1.0) {
    precise vec4 between = abs((b.sum_high - a.sum_high) + (b.sum_low - a.sum_low));
    sum += max(between - (rising ? a.mean : b.mean), 0.0);
  }
  return sum / (in_a + in_b + apart - 1.0);
}

// Composites a segment: its opacity is exact; its colour is the mean emission over the mean extinction, as if both were
// spread evenly over it, which is right to the third order of its length.
void composite_segment(Place front, Place back, float size, float light) {
  vec4 mean = mean_between(front, back);
  composite(mean.rgb * (light / max(mean.a, 1.0e-30)), opacity_of(mean.a * size));
}
#endif
