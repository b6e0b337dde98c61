// The exact march: cell by cell, in each the field as its cubic, cut at its extrema and where it meets a level of the TF
// or a surface (RaySolver is the same in double, with a rule of higher order). There are no samples, and no crossing is
// looked for: one is met when the field leaves a piece of the TF.

#include "cell_field.glsl"
#include "empty_cells.glsl"
#include "surfaces.glsl"
#include "cell_integral.glsl"

#if EMPTY_CELLS
bool is_empty(CellWalk walk) {
  return texelFetch(empty_cells, mix(walk.cells - 1 - walk.cell, walk.cell, greaterThan(walk.step, ivec3(0))), 0).r != 0u;
}
#endif

void composite_surfaces(Ray ray, uint first, uint past, bool rising, float t) {
#if PEAKS
  if (first == past) return;
  float light_here = LIGHT(t);
  for (uint i = first; i < past; ++i) {
    Peak peak = peaks[rising ? i : past - 1u - (i - first)];
    composite(peak.color_opacity.rgb * light_here, peak.color_opacity.a);
    COUNT_CROSSING;
  }
#endif
}

// A march's state between two cells: the field's value, to the bit the same for both, and in which piece of the TF it
// is. Where the value is that of a level it belongs to the side that the ray comes from, until the field goes on or
// stays: inside is {f >= v}, and a touch is no crossing.
struct March {
  float value;
  int index;
  TfPiece piece;
  bool is_first;  // nothing lies before: a level that the ray begins on is not crossed
};

March begin_march(float value) {
  int index = piece_at(value);
  return March(value, index, tf_pieces[index], true);
}

// Mesa 22.3's llvmpipe takes a value that a loop has computed from the last lane that leaves the loop, unless it leaves at
// the loop's head: so each loop here has a bound that a compiler does not know, and cannot turn into one that leaves at
// its foot.

// A cell in which the field may meet a level.
void march_cell(Ray ray, inout March march, CellCorners corners, vec3 from, CellExit leave, float t, float value) {
  vec3 whole = rise_along(corners, from, leave.place);
  vec2 turns = turns_of(whole);
  float length = leave.t - t, s = 0.0, offset = offset_in(march.piece, march.value);
  bool more = true;
  for (int left = 3 * tf_piece_count; more && left > 0; --left) {
    TfPiece piece = march.piece;
    float end = s < turns.x ? turns.x : s < turns.y ? turns.y : 1.0;
    CellPart part = CellPart(rise_from(whole, s), end - s, offset, 0.0, t + s * length, 0.0);
    part.rise = end == 1.0 ? offset_in(piece, value) - offset : rise_at(part.p, part.size);
    bool up = part.rise >= 0.0;
    float target = (up ? piece.most : piece.least) - offset;
    bool meets = up ? part.rise > target || (part.rise == 0.0 && target == 0.0) : part.rise < target;
    if (meets) {
      part.size = solve_rise(part.p, target, part.size, up);
      part.rise = target;
    }
    part.length = part.size * length;
#if DVR
    if (!is_clear(piece) && part.length > 0.0) composite_part(ray, piece, part);
#endif
    if (part.size > 0.0) march.is_first = false;
    more = meets || end < 1.0;
    s = meets ? s + part.size : end;
    offset += part.rise;
    if (meets) {
      march.index += up ? 1 : -1;
      march.piece = tf_pieces[march.index];
      offset = up ? march.piece.least : march.piece.most;
      if (!march.is_first) {
        TfPiece below = piece;
        if (!up) below = march.piece;
        composite_surfaces(ray, below.first_surface, below.past_surface, up, t + s * length);
      }
    }
    more = more && !TERMINATED;
  }
  march.is_first = false;
}

void march_cells(Ray ray, Span span) {
  CellWalk walk = begin_cell_walk(ray, span);
  CellCorners corners = corners_of(walk);
  March march = begin_march(value_at(corners, walk.place));
  bool more = true;
  for (int left = walk.cells.x + walk.cells.y + walk.cells.z; more && left > 0 && !TERMINATED; --left) {
    CellExit leave = exit_of(walk);
    COUNT_SAMPLE;
#if EMPTY_CELLS
    if (is_empty(walk)) {
      more = advance(walk, leave);
      if (more) {
        corners = corners_of(walk);
        march = begin_march(value_at(corners, walk.place));
      }
      continue;
    }
#endif
    float value = value_at(corners, leave.place);
    march_cell(ray, march, corners, walk.place, leave, walk.t, value);
    march.value = value;
    more = advance(walk, leave);
    if (more) corners = corners_of(walk);
  }
}
