// A ray's part in the box is cut where it meets an empty cell: one that the filter would need a NaN or Inf for.

#include "walk.glsl"

#if EMPTY_CELLS
uniform usampler3D empty_cells;  // 1 = this cell is empty

bool is_empty(Walk walk) { return texelFetch(empty_cells, walk.cell, 0).r != 0u; }

// The next span without empty cells. `more` is whether the walk has a cell left.
bool next_span(inout Walk walk, inout bool more, out Span span) {
  while (more && is_empty(walk)) more = advance(walk);
  span = Span(walk.t, walk.end);
  if (!more) return false;
  do more = advance(walk);
  while (more && !is_empty(walk));
  if (more) span.exit = walk.t;
  return true;
}
#endif
