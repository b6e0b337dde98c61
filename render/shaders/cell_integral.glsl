// What a ray collects where the field stays in one piece of the TF, and is monotone or all of a cell long.

#include "compositing.glsl"
#include "shading.glsl"
#include "tf_pieces.glsl"

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

// Composites `size` of the ray, over which the value's fraction of a piece goes from p0 through `middle` to p1: exact
// where it goes evenly. What it bends is taken by Simpson's rule.
void composite_panel(TfPiece piece, float p0, float d0, float middle, float p1, float d1, float size, float light) {
  float straight = 0.5 * (p0 + p1), a0 = piece.low.a + piece.rise.a * p0, a1 = piece.low.a + piece.rise.a * p1;
  vec2 mean = mean_on_line(a0, d0, a1, d1);
  float bent = (2.0 / 3.0) * (depth_in(piece, middle) - depth_in(piece, straight));
  float depth = max(mean.x + bent, 0.0) * extinction_scale * size, alpha = opacity_of(depth);
  // Light from further back is absorbed on the way
  float absorbed = depth < 0.5 ? -depth / 12.0 * (1.0 - depth * depth / 60.0) : 1.0 / depth - (1.0 - alpha) / alpha - 0.5;
  float place = clamp(mean.y + absorbed, 0.0, 1.0);
  float fraction = clamp(mix(p0, p1, place) + (2.0 / 3.0) * (middle - straight), 0.0, 1.0);
  composite((piece.low.rgb + piece.rise.rgb * fraction) * light, alpha);
  COUNT_DVR_SAMPLE;
}

// Along a part of a cell: the value's offset in the piece is `offset` where it begins, and `offset + rise_at(p, s)`
// after a share s of the cell, to s = size, where it has risen by `rise`.
struct CellPart {
  vec3 p;
  float size, offset, rise;
  float t, length;  // where it begins on the ray, and how long it is
};

// Into how many panels a part is divided, so that each is as good as needs be behind `transmittance`: from what the
// rule for a panel leaves out, bends where extinction changes (third order), and colours in thick ones (second).
const float panel_tolerance = 1.0 / 8192.0;
const float most_panels = 16.0;

float panels_of(TfPiece piece, CellPart part, float p0, float d0, float middle, float p1, float d1) {
  vec3 rise = abs(piece.rise.rgb);
  float color = max(rise.r, max(rise.g, rise.b));
  float bump = abs(middle - 0.5 * (p0 + p1)) + 0.05 * abs(part.p.z) * part.size * part.size * part.size * piece.inverse_width;
  float scale = extinction_scale * part.length, depth = min(scale * max(d0, d1), 1.0);
  float clear = max(1.0 - max(piece.low.a + piece.rise.a * p0, piece.low.a + piece.rise.a * p1), 1.0e-7);
  float bend = min(abs(piece.rise.a) * bump / clear, d0 + d1 + 1.0), change = abs(d1 - d0);
  float of_depth = 0.3 * min(scale * bend, 1.0) * min(change + bend, 1.0);
  float of_color = color * depth * (0.05 * depth * (abs(p1 - p0) + bump) + 0.3 * bump * min(change + bend, 1.0));
  float by = transmittance / panel_tolerance;
  float n = max(pow(of_depth * by, 1.0 / 3.0), sqrt(of_color * by));
  return clamp(ceil(n), 1.0, most_panels);
}

void composite_part(Ray ray, TfPiece piece, CellPart part) {
  float p0 = clamp(part.offset * piece.inverse_width, 0.0, 1.0), d0 = depth_in(piece, p0);
  float last = clamp((part.offset + part.rise) * piece.inverse_width, 0.0, 1.0), d_last = depth_in(piece, last);
  float middle = clamp((part.offset + rise_at(part.p, 0.5 * part.size)) * piece.inverse_width, 0.0, 1.0);
  float n = panels_of(piece, part, p0, d0, middle, last, d_last);
  float share = part.size / n, size = part.length / n;
  for (float i = 0.0; i < n; ++i) {
    middle = clamp((part.offset + rise_at(part.p, (i + 0.5) * share)) * piece.inverse_width, 0.0, 1.0);
    float p1 = last, d1 = d_last;
    if (i + 1.0 < n) {
      p1 = clamp((part.offset + rise_at(part.p, (i + 1.0) * share)) * piece.inverse_width, 0.0, 1.0);
      d1 = depth_in(piece, p1);
    }
    composite_panel(piece, p0, d0, middle, p1, d1, size, DVR_LIGHT(part.t + (i + 0.5) * size));
    p0 = p1;
    d0 = d1;
  }
}
