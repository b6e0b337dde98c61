// The TF as its linear pieces, without a table (reference/levels.h): cut at its points, at the surfaces' values, and
// where it becomes nearly opaque. Within a piece values are offsets from its levels, as numbers of their own, so that
// a spike is as exact when it is 1e-7 of the range wide as when it is 1e-1.

struct TfPiece {
  vec4 low, rise;                // colour and opacity at its lower level, and how much more at its upper one
  vec2 low_value, high_value;    // of its levels, as sums of two; beyond all values where there is none
  float width;
};
// Four texels a piece (resources/shader_tf.h). llvmpipe reads a storage buffer lane by lane.
uniform samplerBuffer tf_pieces;
uniform int tf_piece_count;
uniform float extinction_scale;  // of -log(1 - opacity), to be that per smallest spacing

TfPiece tf_piece(int index) {
  vec4 levels = texelFetch(tf_pieces, 4 * index + 2);
  return TfPiece(texelFetch(tf_pieces, 4 * index), texelFetch(tf_pieces, 4 * index + 1), levels.xy, levels.zw,
                 max((levels.z - levels.x) + (levels.w - levels.y), 1.0e-37));
}

// The first surface at the level above a piece, and one past the last.
ivec2 surfaces_above(int index) { return ivec2(texelFetch(tf_pieces, 4 * index + 3).xy); }

// How far a value is above a level: 0 on it alone, however near the next one is.
float above(float value, vec2 level) {
  precise float difference = (value - level.x) - level.y;
  return difference;
}

// The piece that holds a value: at a level the one above it.
int piece_at(float value) {
  int first = 0, last = tf_piece_count - 1;
  while (first < last) {
    int middle = (first + last) / 2;
    vec2 high_value = texelFetch(tf_pieces, 4 * middle + 2).zw;
    if (above(value, high_value) >= 0.0)
      first = middle + 1;
    else
      last = middle;
  }
  return first;
}

// How far a value is above the lower level, and below the upper one: each has its own digits near its level.
struct Offsets {
  float above_low, below_high;
};

Offsets offsets_in(TfPiece piece, float value) {
  return Offsets(above(value, piece.low_value), -above(value, piece.high_value));
}

float fraction_of(TfPiece piece, float above_low) { return clamp(above_low / piece.width, 0.0, 1.0); }

bool is_clear(TfPiece piece) { return piece.low.a == 0.0 && piece.rise.a == 0.0; }

// -log(1 - opacity) at a fraction of a piece. 1 - opacity is taken from both ends, where it keeps its digits.
float depth_in(TfPiece piece, float fraction) {
  float opacity = piece.low.a + piece.rise.a * fraction;
  float clear_low = 1.0 - piece.low.a, clear = mix(clear_low, clear_low - piece.rise.a, fraction);
  return opacity < 0.01 ? depth_of(opacity) : -log(max(clear, 5.9604645e-8));
}
