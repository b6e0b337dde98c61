// How far a pixel may be from the exact answer: the sum over all parts of what Simpson's rule, the mean colour, and the
// rounding of 32-bit float leave out or change, each behind the present transmittance. Light is not in it: there is no
// exact answer of what is shaded.

#if STATISTICS
float error_bound = 0.0;
float value_error;               // of the field's value, along the present part
float transmittance_slack = 1.0;  // what lies in front may be clearer than it came out

// Of the part before: how much the field rose, its error, and how much of the ray lies within it of where the part ends.
float rise_before, error_before, reach_before;
float transmittance_at_turn;  // what was met since the field last turned may not be there

void begin_errors() {
  value_error = rise_before = reach_before = 0.0;
  error_before = 3.0e38;
  transmittance_at_turn = transmittance;
}

const float rounding = 1.0e-6;  // of a few operations, relative

void add_error(float error) { error_bound += transmittance * transmittance_slack * error; }
void add_turn_error(float error) { error_bound += transmittance_at_turn * transmittance_slack * error; }

// A panel in which the fraction of the piece is p(x), x from 0 to 1, between p0 and p1: `b` are its coefficients of x, x^2
// and x^3. `scale` times -log(1 - opacity) is the optical depth of a panel of it; this one's came out as `depth`.
void add_panel_error(TfPiece piece, vec3 b, float p0, float p1, float scale, float depth) {
  // Bounds of the derivatives of p, and where it can be
  vec3 p = vec3(abs(b.x) + 2.0 * abs(b.y) + 3.0 * abs(b.z), max(abs(2.0 * b.y), abs(2.0 * b.y + 6.0 * b.z)), 6.0 * abs(b.z));
  float beyond = 0.5 * max(p.x - abs(p1 - p0), 0.0);
  float low = max(min(p0, p1) - beyond, 0.0), high = min(max(p0, p1) + beyond, 1.0), apart = high - low;
  float clear = max(1.0 - piece.low.a - max(piece.rise.a * low, piece.rise.a * high), 5.9e-8);
  // Of opacity by transparency, and of g = -log(1 - opacity) by Faa di Bruno's formula
  float slope = abs(piece.rise.a) / clear;
  vec3 u = slope * p;
  float g1 = u.x, g2 = u.y + u.x * u.x, g3 = u.z + u.x * (3.0 * u.y + 2.0 * u.x * u.x);
  float g4 = 4.0 * u.x * u.z + 3.0 * u.y * u.y + 12.0 * u.x * u.x * u.y + 6.0 * u.x * u.x * u.x * u.x;
  // Simpson's rule leaves out a 2880th of the fourth derivative at most, and no more than g changes
  float g_low = depth_in(piece, low), g_high = depth_in(piece, high), change = abs(g_high - g_low);
  float fraction_error = min(value_error / piece.width, 1.0);
  float of_depth = scale * (min(g4 / 2880.0, change) + slope * fraction_error) + rounding * (4.0 * depth + scale);
  add_error(min(of_depth, 1.0) * exp(-max(depth - of_depth, 0.0)));
  // Of the mean fraction, weighted with extinction; then of how absorption on the way moves it
  float moment = min((g4 * apart + 4.0 * g3 * p.x + 6.0 * g2 * p.y + 4.0 * g1 * p.z) / 2880.0, max(g_low, g_high) * apart);
  float of_mean = (scale * moment + apart * of_depth) / max(depth, 1.0e-30);
  float uneven = min(scale * change / max(4.0 * (depth - of_depth), 1.0e-30), 1.0);
  float of_place = min(0.25 * p.y + 2.0 * p.x * uneven, apart) * min(0.25 * depth, 2.0) +
                   apart * min(0.032, 2.4e-4 * depth * depth * depth);
  vec3 color = abs(piece.rise.rgb);
  float of_color = min(of_mean + of_place, apart) + fraction_error;
  add_error(max(color.r, max(color.g, color.b)) * of_color * opacity_of(depth + of_depth) + 2.0 * rounding);
  error_bound += 0.12 * rounding * collected.a;  // what is added to much loses digits
  transmittance_slack = min(transmittance_slack * (1.0 + of_depth), 1.0e3);
}

// The share of a cell in which a field that rises with this slope and bend is within `value_error` of a value.
float share_within_error(float slope, float bend) {
  return min(2.0 * value_error / max(abs(slope), 1.0e-30), 3.0 * sqrt(value_error / max(abs(bend), 1.0e-30)));
}

#endif
