// What a ray collects along a part of a cell in which the field stays in one piece of the TF.

#include "compositing.glsl"
#include "shading.glsl"
#include "tf_pieces.glsl"
#include "error_bound.glsl"

// The value is `offset` above the piece's lower level where the part begins, `offset + rise_at(p, s)` after a share s of
// the cell, to s = size, where it has risen by `rise`.
struct CellPart {
  vec3 p;
  float size, offset, rise;
  float t, length;  // where it begins on the ray, and how long it is
};

// Composites a panel of this depth, with the light of a fraction of the piece. Light from further back is absorbed on the
// way: where the fraction goes from p0 to p1, what comes through is from nearer by
// 1/2 - (1/depth - 1/(exp(depth) - 1)) of the way, here to 0.032.
void composite_depth(TfPiece piece, float depth, float fraction, float p0, float p1, float light) {
  fraction -= (p1 - p0) * 0.5 * depth * inversesqrt(36.0 + depth * depth);
  composite((piece.low.rgb + piece.rise.rgb * clamp(fraction, 0.0, 1.0)) * light, opacity_of(depth));
  COUNT_DVR_SAMPLE;
}

// Into how many panels a part is divided, so that what the rule leaves out, behind the present transmittance, is small:
// bends where extinction changes, an extinction that changes much, and colours in thick ones.
// Estimates, not bounds: their factors were set so that random scenes come out right (Analytic.RandomScenesAreExact).
const float panel_tolerance = 1.0 / 8192.0;
const float most_panels = 16.0;

// An upper bound of log(1 + x), which takes no logarithm: 1.35 times it at x = 15, the most between two cuts of a piece
// that is not nearly opaque.
float most_depth(float x) { return x * inversesqrt(1.0 + x); }

float panels_of(TfPiece piece, CellPart part, float p0, float middle, float p1) {
  vec3 rise = abs(piece.rise.rgb);
  float color = max(rise.r, max(rise.g, rise.b));
  float bump = abs(middle - 0.5 * (p0 + p1)) + 0.05 * abs(part.p.z) * part.size * part.size * part.size / piece.width;
  float a0 = piece.low.a + piece.rise.a * p0, a1 = piece.low.a + piece.rise.a * p1, most = max(a0, a1);
  float clear = max(1.0 - most, 6.0e-8), scale = extinction_scale * part.length;
  float depth = min(scale * most_depth(most / clear), 1.0), change = most_depth(abs(a1 - a0) / clear);
  float bend = min(abs(piece.rise.a) * bump / clear, 17.0), moved = min(change + bend, 1.0);
  float of_depth = 0.3 * min(scale * bend, 1.0) * moved + scale * change * change * change * change / 480.0;
  float of_color = color * depth * (0.05 * depth * (abs(p1 - p0) + bump) + 0.3 * bump * moved);
  return clamp(ceil(sqrt(max(of_depth, of_color) * (transmittance / panel_tolerance))), 1.0, most_panels);
}

void composite_part(Ray ray, TfPiece piece, CellPart part) {
  float p0 = fraction_of(piece, part.offset), last = fraction_of(piece, part.offset + part.rise);
  float middle = fraction_of(piece, part.offset + rise_at(part.p, 0.5 * part.size));
  float panels = panels_of(piece, part, p0, middle, last);
  float share = part.size / panels, size = part.length / panels;
  float d0 = depth_in(piece, p0);
  if (is_clear(piece)) panels = 0.0;
  for (float i = 0.0; i < panels; ++i) {
    middle = fraction_of(piece, part.offset + rise_at(part.p, (i + 0.5) * share));
    float d = depth_in(piece, middle);
    float p1 = i + 1.0 < panels ? fraction_of(piece, part.offset + rise_at(part.p, (i + 1.0) * share)) : last;
    float d1 = depth_in(piece, p1);
    float sum = d0 + 4.0 * d + d1, fraction = (d0 * p0 + 4.0 * d * middle + d1 * p1) / max(sum, 1.0e-30);
    float depth = extinction_scale * size * sum / 6.0;
#if STATISTICS
    vec3 bends = rise_from(part.p, i * share) * vec3(share, share * share, share * share * share);
    add_panel_error(piece, bends / piece.width, p0, p1, extinction_scale * size, depth);
#endif
    composite_depth(piece, depth, fraction, p0, p1, DVR_LIGHT(part.t + (i + 0.5) * size));
    p0 = p1;
    d0 = d1;
  }
}
