// The TF as its linear pieces, without a table (reference/levels.h): cut at its points, at the opacity cap, and at the
// surfaces' values. Within a piece values are offsets from its `base`, as numbers of their own, so that a spike is as
// exact when it is 1e-7 of the range wide as when it is 1e-1.

struct TfPiece {
  vec4 low, rise;     // colour and opacity at its lower level, and how much more at its upper one
  float base;         // offsets are from this value: the lower level's, or in the first piece the upper one's
  float least, most;  // offsets of its levels; -3e38 and 3e38 where there is none
  float inverse_width;                // 0 beyond the TF's ends
  float low_value, high_value;        // the levels' own, rounded
  uint first_surface, past_surface;   // those of the level above it
};
layout(std430, binding = 1) readonly buffer TfPieces { TfPiece tf_pieces[]; };
uniform int tf_piece_count;
uniform float extinction_scale;  // of -log(1 - opacity), to be that per smallest spacing

// The piece that holds a value: at a level the one above it.
int piece_at(float value) {
  int first = 0, last = tf_piece_count - 1;
  while (first < last) {
    int middle = (first + last) / 2;
    if (tf_pieces[middle].high_value <= value)
      first = middle + 1;
    else
      last = middle;
  }
  return first;
}

// Where a value that lies in a piece, or beyond it, is in it.
float offset_in(TfPiece piece, float value) {
  return value >= piece.high_value ? piece.most + (value - piece.high_value) : min(value - piece.base, piece.most);
}

bool is_clear(TfPiece piece) { return piece.low.a == 0.0 && piece.rise.a == 0.0; }

// -log(1 - opacity) at a fraction of a piece. Both ends' digits are kept, those of faint and of opaque materials.
float depth_in(TfPiece piece, float fraction) {
  float opacity = piece.low.a + piece.rise.a * fraction;
  float clear_low = 1.0 - piece.low.a, clear_high = clear_low - piece.rise.a;
  return opacity < 0.01 ? depth_of(opacity) : -log(max(mix(clear_low, clear_high, fraction), 5.9604645e-8));
}
