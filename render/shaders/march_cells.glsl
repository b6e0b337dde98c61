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

#if PEAKS
void composite_surfaces(Ray ray, int first, int past, bool rising, float t) {
  if (first == past) return;
  float light_here = LIGHT(t);
  for (int i = first; i < past; ++i) {
    Peak peak = peaks[rising ? i : past - 1 - (i - first)];
#if STATISTICS
    add_error(rounding * peak.color_opacity.a);
#endif
    composite(peak.color_opacity.rgb * light_here, peak.color_opacity.a);
    COUNT_CROSSING;
  }
}
#endif

// A march's state: the cell, how far the ray is in it, and in which piece of the TF the field is there. Where its value
// is that of a level it belongs to the side that the ray comes from, until the field goes on or stays: inside is
// {f >= v}, and a touch is no crossing.
struct March {
  CellWalk walk;
  CellCorners corners;
  float s;          // the share of the cell that lies behind; 2 when it is done with
  Offsets offsets;  // of the field's value there
  int index;
  TfPiece piece;
  bool is_first;  // nothing lies before: a level that the ray begins on is not crossed
  bool more;
};

void find_piece(inout March m) {
  m.index = piece_at(value_at(m.corners, entry_place(m.walk)));
  m.piece = tf_piece(m.index);
  m.is_first = true;
}

#if LONG_RAYS
// Where the pass before ended: on a level the field is still on the side that it comes from.
void continue_piece(inout March m) {
  float value = value_at(m.corners, entry_place(m.walk));
  vec3 rise = rise_along(m.corners, entry_place(m.walk), exit_place(m.walk, exit_of(m.walk)));
  if (above(value, m.piece.low_value) == 0.0 && rise.x > 0.0 && m.index > 0) m.piece = tf_piece(--m.index);
  m.is_first = false;
}
#endif

#if EMPTY_CELLS
#define MAY_BE_EMPTY is_empty(m.walk)
#else
#define MAY_BE_EMPTY false
#endif

// Whether the field stays in one piece of the TF all through the cell.
bool stays_in_piece(March m) {
  vec2 range = range_of(m.corners);
  return range.x > m.piece.low_value.x && range.y < m.piece.high_value.x;
}

bool shows_nothing(March m) { return is_clear(m.piece) && stays_in_piece(m) && !MAY_BE_EMPTY; }

// To the next cell, with its corners.
void enter_next_cell(inout March m) {
  COUNT_SAMPLE;
  CellExit leave = exit_of(m.walk);
  m.is_first = m.is_first && !(leave.t > m.walk.t);
  m.more = advance(m.walk, leave);
  if (m.more) m.corners = next_corners(m.walk, m.corners);
  m.s = 0.0;
}

#include "march_errors.glsl"

// Takes the ray one part further: to the next level, the field's next extremum, or the cell's end.
void march_part(Ray ray, inout March m) {
  CellExit leave = exit_of(m.walk);
  vec3 from = entry_place(m.walk), to = exit_place(m.walk, leave);
  vec3 whole = rise_along(m.corners, from, to);
  vec2 turns = stays_in_piece(m) ? vec2(1.0) : turns_of(whole);
  float length = leave.t - m.walk.t;
  if (m.s == 0.0) m.offsets = offsets_in(m.piece, value_at(m.corners, from));
  Offsets begin = m.offsets;
  float end = m.s < turns.x ? turns.x : m.s < turns.y ? turns.y : 1.0;
  CellPart part = CellPart(rise_from(whole, m.s), end - m.s, begin.above_low, 0.0, m.walk.t + m.s * length, 0.0);
  part.rise = rise_at(part.p, part.size);
  Offsets ending = Offsets(begin.above_low + part.rise, begin.below_high - part.rise);
  if (end == 1.0) {  // the value on the face is that of both cells
    ending = offsets_in(m.piece, value_at(m.corners, to));
    part.rise = begin.below_high < begin.above_low ? begin.below_high - ending.below_high
                                                   : ending.above_low - begin.above_low;
  }
  // A level is met if the field goes beyond it, or if it stays on the upper one
  bool up = part.rise >= 0.0, stays = part.rise == 0.0 && begin.below_high == 0.0 && length > 0.0;
  bool meets = up ? ending.below_high < 0.0 || stays : ending.above_low < 0.0;
  ADD_BEGIN_ERROR(part, from, to, length);
  float target = up ? begin.below_high : -begin.above_low;
  if (meets) {
    part.size = solve_rise(part.p, target, part.size, part.rise);
    part.rise = target;
  }
  part.length = part.size * length;
#if DVR
  composite_part(ray, m.piece, part);
#endif
  m.is_first = m.is_first && !(part.length > 0.0);
  m.s = meets ? m.s + part.size : end < 1.0 ? end : 2.0;
  m.offsets = ending;
  if (meets) {
    TfPiece left = m.piece;
    m.index += up ? 1 : -1;
    m.piece = tf_piece(m.index);
    m.offsets = up ? Offsets(0.0, m.piece.width) : Offsets(m.piece.width, 0.0);
#if PEAKS
    ivec2 crossed = surfaces_above(up ? m.index - 1 : m.index);
#else
    ivec2 crossed = ivec2(0);
#endif
    ADD_MEETING_ERROR(left, part, up, target, length, crossed.x < crossed.y);
#if PEAKS
    composite_surfaces(ray, crossed.x, m.is_first ? crossed.x : crossed.y, up, m.walk.t + m.s * length);
#endif
  }
  END_PART_ERROR(part, meets, length);
}

// Mesa 22.3's llvmpipe takes a value that a loop has computed from the last lane that leaves the loop, unless it leaves at
// the loop's head: so each loop here has a bound that a compiler does not know, and cannot turn into one that leaves at
// its foot.

// On SIMD hardware all lanes pay for what one does: a round is the same for all, one part of the ray, and cells in which
// nothing is to be done are left in a loop of their own.
void march_cells(Ray ray, Span span) {
  March m;
  m.walk = begin_cell_walk(ray, span);
  m.corners = corners_of(m.walk);
  m.s = 0.0;
  m.offsets = Offsets(3.0e38, 3.0e38);
  BEGIN_ERRORS;
  m.more = true;
  find_piece(m);
#if LONG_RAYS
  if (first_interval > 0 && span.enter == pass_begin) continue_piece(m);
#endif
  int most_cells = m.walk.cells.x + m.walk.cells.y + m.walk.cells.z;
  for (uint left = 3u * uint(most_cells) * uint(tf_piece_count); m.more && left > 0u && !TERMINATED; --left) {
    bool leave = m.s > 1.0 || (m.s == 0.0 && shows_nothing(m));
    for (int cells = most_cells; leave && cells > 0; --cells) {
      enter_next_cell(m);
      leave = m.more && shows_nothing(m);
    }
#if EMPTY_CELLS
    bool empty = m.more && m.s == 0.0 && MAY_BE_EMPTY;
    if (empty) {
      ADD_EXIT_ERROR;
      BEGIN_ERRORS;
    }
    for (int cells = most_cells; empty && cells > 0; --cells) {
      enter_next_cell(m);
      empty = m.more && MAY_BE_EMPTY;
      if (!empty) find_piece(m);
    }
#endif
    if (m.more) march_part(ray, m);
    if (!m.more) {
      ADD_EXIT_ERROR;
    }
  }
}
