// The TF as its linear pieces, without a table (reference/levels.h): cut at its points, at the surfaces' values, and
// where it becomes nearly opaque. Within a piece values are offsets from its `base`, as numbers of their own, so that a
// spike is as exact when it is 1e-7 of the range wide as when it is 1e-1.

struct TfPiece {
  vec4 low, rise;     // colour and opacity at its lower level, and how much more at its upper one
  float base;         // offsets are from this value: the lower level's, or in the first piece the upper one's
  float least, most;  // offsets of its levels; -3e38 and 3e38 where there is none
  float inverse_width;              // 0 beyond the TF's ends
  float low_value, high_value;      // the levels' own, rounded
  int first_surface, past_surface;  // those of the level above it
  vec4 depth_even, depth_odd;       // coefficients of depth_in
};
// Six texels a piece, its members in their order. (llvmpipe reads a storage buffer lane by lane.)
uniform samplerBuffer tf_pieces;
uniform int tf_piece_count;
uniform float extinction_scale;  // of -log(1 - opacity), to be that per smallest spacing

TfPiece tf_piece(int index) {
  int i = 6 * index;
  vec4 offsets = texelFetch(tf_pieces, i + 2), values = texelFetch(tf_pieces, i + 3);
  return TfPiece(texelFetch(tf_pieces, i), texelFetch(tf_pieces, i + 1), offsets.x, offsets.y, offsets.z, offsets.w,
                 values.x, values.y, int(values.z), int(values.w), texelFetch(tf_pieces, i + 4),
                 texelFetch(tf_pieces, i + 5));
}

// The piece that holds a value: at a level the one above it.
int piece_at(float value) {
  int first = 0, last = tf_piece_count - 1;
  while (first < last) {
    int middle = (first + last) / 2;
    if (texelFetch(tf_pieces, 6 * middle + 3).y <= value)
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

float fraction_of(TfPiece piece, float offset) { return clamp(offset * piece.inverse_width, 0.0, 1.0); }

bool is_clear(TfPiece piece) { return piece.low.a == 0.0 && piece.rise.a == 0.0; }

// -log(1 - opacity) at a fraction of a piece, by a polynomial (resources/tf_pieces_buffer.h): a logarithm takes five
// times as long. Where it has none, since opacity comes near 1, is_steep.
float depth_in(TfPiece piece, float fraction) {
  float x = 2.0 * fraction - 1.0, y = x * x;
  vec4 even = piece.depth_even, odd = piece.depth_odd;
  float by_opacity = even.x + y * (even.y + y * (even.z + y * even.w)) + x * (odd.x + y * (odd.y + y * (odd.z + y * odd.w)));
  return (piece.low.a + piece.rise.a * fraction) * by_opacity;
}

bool is_steep(TfPiece piece) { return piece.depth_even.x == 0.0; }

// The same where it is steep. Both ends' digits are kept.
float steep_depth_in(TfPiece piece, float fraction) {
  float clear_low = 1.0 - piece.low.a;
  return -log(max(mix(clear_low, clear_low - piece.rise.a, fraction), 5.9604645e-8));
}
