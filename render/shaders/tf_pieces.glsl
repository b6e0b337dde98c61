// The TF as its linear pieces, without a table (reference/levels.h): cut at its points, at the surfaces' values, and
// where it becomes nearly opaque. Within a piece values are offsets from its `base`, as numbers of their own, so that a
// spike is as exact when it is 1e-7 of the range wide as when it is 1e-1.

struct TfPiece {
  vec4 low, rise;       // colour and opacity at its lower level, and how much more at its upper one
  float base;           // offsets are from this value: the lower level's, or in the first piece the upper one's
  float least, most;    // offsets of its levels; beyond all values where there is none
  float inverse_width;  // 0 beyond the TF's ends
  float low_value, high_value;  // the levels' own, rounded
};
// Four texels a piece (resources/shader_tf.h). llvmpipe reads a storage buffer lane by lane.
uniform samplerBuffer tf_pieces;
uniform int tf_piece_count;
uniform float extinction_scale;  // of -log(1 - opacity), to be that per smallest spacing

TfPiece tf_piece(int index) {
  vec4 place = texelFetch(tf_pieces, 4 * index + 2);
  bool is_first = index == 0;
  return TfPiece(texelFetch(tf_pieces, 4 * index), texelFetch(tf_pieces, 4 * index + 1), place.x,
                 is_first ? -3.0e38 : 0.0, place.y, place.z, is_first ? -3.0e38 : place.x, place.w);
}

// The first surface at the level above a piece, and one past the last.
ivec2 surfaces_above(int index) { return ivec2(texelFetch(tf_pieces, 4 * index + 3).xy); }

// The piece that holds a value: at a level the one above it.
int piece_at(float value) {
  int first = 0, last = tf_piece_count - 1;
  while (first < last) {
    int middle = (first + last) / 2;
    if (texelFetch(tf_pieces, 4 * middle + 2).w <= value)
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

// -log(1 - opacity) at a fraction of a piece. 1 - opacity is taken from both ends, where it keeps its digits.
float depth_in(TfPiece piece, float fraction) {
  float opacity = piece.low.a + piece.rise.a * fraction;
  float clear_low = 1.0 - piece.low.a, clear = mix(clear_low, clear_low - piece.rise.a, fraction);
  return opacity < 0.01 ? depth_of(opacity) : -log(max(clear, 5.9604645e-8));
}
