// Peak finding (Knoll et al. 2009, section 4.2 and appendix): which peaks a segment may cross, whether it does, where.

#include "field.glsl"
#include "surfaces.glsl"

// A place on the ray where the field's value is known.
struct Knot {
  float t, value;
};

// A step composites all its crossings; in the paper's form, as published, only so many.
#if EXTREMA
#define IS_FULL(found) false
#else
uniform int max_peaks;
#define IS_FULL(found) (found >= max_peaks)
#endif

#if PEAK_TABLE
// The paper's table of entry and exit values (section 4.1), as two arrays over the bins. The peaks that a segment may
// cross are a run of the sorted ones: its least value tells where the run begins, its greatest where it ends. x and z
// are the isovalue and the index of the first peak that may be in the bin or above it, y and w the isovalue of the last
// one that may be in it or below and one past its index. A run that ends before it begins is the flag "no peak".
uniform sampler1D peak_table;
uniform vec2 bin_min_scale;  // the bin is (value - x) * y, rounded down

int bin_of(float value) {
  return clamp(int((value - bin_min_scale.x) * bin_min_scale.y), 0, textureSize(peak_table, 0).x - 1);
}

// Whether a segment whose values lie in [least, most] may cross a peak, and which: the order is the caller's.
bool may_cross(float least, float most) {
  float first = texelFetch(peak_table, bin_of(least), 0).x, last = texelFetch(peak_table, bin_of(most), 0).y;
  return first <= most && last >= least;
}

void find_candidates(float least, float most, out uint first, out uint count) {
  float begin = texelFetch(peak_table, bin_of(least), 0).z, past = texelFetch(peak_table, bin_of(most), 0).w;
  first = uint(begin);
  count = uint(max(past - begin, 0.0));
}

// Whether a peak lies in [least, most] indeed.
bool holds_peak(float least, float most) {
  uint first, count;
  find_candidates(least, most, first, count);
  for (uint k = first; k < first + count; ++k)
    if (peaks[k].value >= least && peaks[k].value <= most) return true;
  return false;
}
#elif PEAK_LIST
// So few that all of them are tested: their values, and beyond them infinity.
uniform vec4 few_peaks;
uniform int peak_count;

bool may_cross(float least, float most) {
  bvec4 above_least = greaterThanEqual(few_peaks, vec4(least));
  bvec4 below_most = lessThanEqual(few_peaks, vec4(most));
  return any(bvec4(ivec4(above_least) & ivec4(below_most)));
}

#if !SEVERAL_PEAKS
void find_candidates(float least, float most, out uint first, out uint count) {
  first = min(uint(dot(vec4(lessThan(few_peaks, vec4(least))), vec4(1.0))), uint(peak_count) - 1u);
  count = 1u;
}
#endif
#else
// A single one.
uniform vec4 few_peaks;

bool may_cross(float least, float most) { return few_peaks.x >= least && few_peaks.x <= most; }

void find_candidates(float least, float most, out uint first, out uint count) {
  first = 0u;
  count = 1u;
}
#endif

// Inside is {f >= v}; a crossing lies between two parts of positive length. A sample exactly on v belongs to
// the side that it came from, or, when the field stays on v, to the inside: so a touch is no crossing, and a
// crossing at a sample is one. `before` is the sample before f0 (at the entry, f1 itself).
bool crosses(float v, float before, float f0, float f1) {
  bool inside0 = f0 > v || (f0 == v && before >= v);
  bool inside1 = f1 > v || (f1 == v && f0 >= v);
  return inside0 != inside1;
}

// Three steps of the secant method with a bracket (eq. 5); the last one is not evaluated, since the value is known.
float solve(Ray ray, Knot a, Knot b, float v) {
  float t0 = a.t, t1 = b.t, f0 = a.value - v, f1 = b.value - v;
  if (f0 == 0.0) return t0;
  for (int i = 0; i < 2; ++i) {
    float t = t0 - (t1 - t0) * (f0 / (f1 - f0));
    float f = field(at(ray, t)) - v;
    if ((f >= 0.0) == (f1 >= 0.0)) {
      t1 = t;
      f1 = f;
    } else {
      t0 = t;
      f0 = f;
    }
  }
  return f1 == f0 ? t0 : clamp(t0 - (t1 - t0) * (f0 / (f1 - f0)), a.t, b.t);
}
