// What a ray collects along a part of a cell in which the field stays in one piece of the TF.

#include "compositing.glsl"
#include "shading.glsl"
#include "tf_pieces.glsl"

// The value's offset in the piece is `offset` where the part begins, `offset + rise_at(p, s)` after a share s of the
// cell, to s = size, where it has risen by `rise`.
struct CellPart {
  vec3 p;
  float size, offset, rise;
  float t, length;  // where it begins on the ray, and how long it is
};

// Composites `size` of a ray with this depth in all, and the light of a fraction of the piece. Light from further back is
// absorbed on the way: where the fraction goes from p0 to p1, what comes through is from nearer by
// 1/2 - (1/depth - 1/(exp(depth) - 1)) of the way, here to 0.02.
void composite_depth(TfPiece piece, float depth, float fraction, float p0, float p1, float light) {
  fraction -= (p1 - p0) * depth / (12.0 + 0.2 * depth * depth);
  composite((piece.low.rgb + piece.rise.rgb * clamp(fraction, 0.0, 1.0)) * light, opacity_of(depth));
  COUNT_DVR_SAMPLE;
}

// Into how many panels a part is divided, so that what the rule leaves out, behind the present transmittance, is small:
// bends where extinction changes, an extinction that changes much, and colours in thick ones.
const float panel_tolerance = 1.0 / 8192.0;
const float most_panels = 16.0;

float panels_of(TfPiece piece, CellPart part, float p0, float d0, float middle, float p1, float d1) {
  vec3 rise = abs(piece.rise.rgb);
  float color = max(rise.r, max(rise.g, rise.b));
  float bump = abs(middle - 0.5 * (p0 + p1)) + 0.05 * abs(part.p.z) * part.size * part.size * part.size * piece.inverse_width;
  float scale = extinction_scale * part.length, depth = min(scale * max(d0, d1), 1.0);
  float clear = max(1.0 - max(piece.low.a + piece.rise.a * p0, piece.low.a + piece.rise.a * p1), 1.0e-7);
  float change = abs(d1 - d0), bend = min(abs(piece.rise.a) * bump / clear, d0 + d1 + 1.0);
  float moved = min(change + bend, 1.0);
  float of_depth = 0.3 * min(scale * bend, 1.0) * moved;
  if (!is_steep(piece)) of_depth += scale * change * change * change * change / 480.0;
  float of_color = color * depth * (0.05 * depth * (abs(p1 - p0) + bump) + 0.3 * bump * moved);
  return clamp(ceil(sqrt(max(of_depth, of_color) * (transmittance / panel_tolerance))), 1.0, most_panels);
}

// Mean of -log(1 - a) over a line from opacity a0 to a1, where it is d0 and d1, in closed form; and the place on the
// line, from 0 to 1, that it has on average. (With t = (1 - a) / (1 - min(a0, a1)) = 1 - u y: the integrals of -log t
// and of -y log t. Series where they cancel.)
vec2 mean_on_line(float a0, float d0, float a1, float d1) {
  float least = min(d0, d1), delta = abs(d1 - d0);
  float u = abs(a1 - a0) / max(1.0 - min(a0, a1), 1.0e-30);
  float clear = 1.0 - u, mean, moment;
  if (u < 0.2) {
    mean = u * (0.5 + u * (1.0 / 6.0 + u * (1.0 / 12.0 + u * (0.05 + u / 30.0))));
    moment = u * (1.0 / 3.0 + u * (0.125 + u * (1.0 / 15.0 + u * (1.0 / 24.0 + u / 35.0))));
  } else {
    mean = 1.0 - clear * delta / u;
    moment = (0.75 - (1.0 + delta) * clear + (0.25 + 0.5 * delta) * clear * clear) / (u * u);
  }
  float sum = least + mean, place = sum > 0.0 ? (0.5 * least + moment) / sum : 0.5;
  return vec2(sum, a1 < a0 ? 1.0 - place : place);
}

// A panel where extinction is steep: exact if the value goes evenly; what it bends is taken by Simpson's rule.
void composite_steep_panel(TfPiece piece, float p0, float middle, float p1, float size, float light) {
  float straight = 0.5 * (p0 + p1), a0 = piece.low.a + piece.rise.a * p0, a1 = piece.low.a + piece.rise.a * p1;
  vec2 mean = mean_on_line(a0, steep_depth_in(piece, p0), a1, steep_depth_in(piece, p1));
  float bent = (2.0 / 3.0) * (steep_depth_in(piece, middle) - steep_depth_in(piece, straight));
  float fraction = mix(p0, p1, mean.y) + (2.0 / 3.0) * (middle - straight);
  composite_depth(piece, max(mean.x + bent, 0.0) * extinction_scale * size, fraction, p0, p1, light);
}

// On SIMD hardware all lanes pay for what one does, unless it is in a loop that they do not enter.
void composite_part(Ray ray, TfPiece piece, CellPart part) {
  float p0 = fraction_of(piece, part.offset), d0 = depth_in(piece, p0);
  float last = fraction_of(piece, part.offset + part.rise), d_last = depth_in(piece, last);
  float middle = fraction_of(piece, part.offset + rise_at(part.p, 0.5 * part.size));
  bool steep = is_steep(piece);
  if (steep) {
    d0 = 0.0;
    d_last = 16.6;  // as it may be
  }
  float n = panels_of(piece, part, p0, d0, middle, last, d_last);
  float share = part.size / n, size = part.length / n;
  if (is_clear(piece)) n = 0.0;
  float panels = steep ? 0.0 : n, steep_panels = steep ? n : 0.0;
  for (float i = 0.0; i < panels; ++i) {
    float middle = fraction_of(piece, part.offset + rise_at(part.p, (i + 0.5) * share)), d = depth_in(piece, middle);
    float p1 = last;
    if (i + 1.0 < panels) p1 = fraction_of(piece, part.offset + rise_at(part.p, (i + 1.0) * share));
    float d1 = depth_in(piece, p1);
    float sum = d0 + 4.0 * d + d1, fraction = (d0 * p0 + 4.0 * d * middle + d1 * p1) / max(sum, 1.0e-30);
    composite_depth(piece, extinction_scale * size * sum / 6.0, fraction, p0, p1, DVR_LIGHT(part.t + (i + 0.5) * size));
    p0 = p1;
    d0 = d1;
  }
  for (float i = 0.0; i < steep_panels; ++i) {
    float middle = fraction_of(piece, part.offset + rise_at(part.p, (i + 0.5) * share));
    float p1 = last;
    if (i + 1.0 < steep_panels) p1 = fraction_of(piece, part.offset + rise_at(part.p, (i + 1.0) * share));
    composite_steep_panel(piece, p0, middle, p1, size, DVR_LIGHT(part.t + (i + 0.5) * size));
    p0 = p1;
  }
}
