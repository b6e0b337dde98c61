// Where the exact march may err, as it goes: what is added to the error bound (error_bound.glsl) where a part of a ray begins,
// meets a level, and ends. Without STATISTICS there is none of it.

#if STATISTICS
uniform float neighbour_range;  // no cell's values are further apart

float greatest(vec3 v) { return max(v.x, max(v.y, v.z)); }

// How much a place on the ray may be off, in smallest spacings: the more, the flatter the ray meets a face there.
float place_error(Ray ray, March m, float t) {
  vec3 position = at(ray, t), place = cell_place_at(m.walk, t);
  vec3 beside = min(min(abs(position - rendered_min), abs(position - rendered_max)), min(place, 1.0 - place));
  vec3 flatness = mix(vec3(1.0), 1.0 / max(abs(ray.direction), vec3(1.0e-30)), lessThan(beside, vec3(1.0e-3)));
  return rounding * (max(abs(t), greatest(abs(position))) + 1.0) * greatest(flatness);
}

// What 32-bit positions and values may do to the field in a cell: nothing where all its corners are equal, unless the ray
// runs so near to a face that it may be in the next one.
float value_error_in(March m, vec3 from, vec3 to) {
  vec2 range = range_of(m.corners);
  float place = max(abs(m.walk.t), greatest(abs(m.walk.origin))) + 1.0, size = range.y - range.x;
  vec3 beside = min(max(from, to), max(1.0 - from, 1.0 - to));
  if (any(lessThan(beside, vec3(rounding * place)))) size = max(size, neighbour_range);
  return size > 0.0 ? rounding * (max(abs(range.x), abs(range.y)) + size * place) : 0.0;
}

// The levels within `error` of the value where the field turns, or the ray begins or ends: their surfaces, there and back,
// and what the pieces beyond them make of a part `length` long, may be missed or invented.
void add_near_levels(March m, float error, float length) {
  float opacity = 0.0, depth = 0.0;
  for (int side = 0; side < 2; ++side) {
    float distance = side == 0 ? m.offsets.below_high : m.offsets.above_low;
    int index = m.index, next = side == 0 ? 1 : -1;
    for (int left = tf_piece_count; left > 0 && distance < error && index + next >= 0 && index + next < tf_piece_count; --left) {
#if PEAKS
      ivec2 surfaces = surfaces_above(side == 0 ? index : index - 1);
      for (int i = surfaces.x; i < surfaces.y; ++i) opacity += 2.0 * peaks[i].color_opacity.a;
#endif
      index += next;
      TfPiece beyond = tf_piece(index);
      float into = min((error - distance) / beyond.width, 1.0), edge = side == 0 ? 0.0 : 1.0;
      depth = max(depth, max(depth_in(beyond, edge), depth_in(beyond, abs(edge - into))));
      distance += beyond.width;
    }
  }
  add_turn_error(min(opacity + opacity_of(extinction_scale * length * depth), 1.0));
}

// Where the ray begins or ends: the place is off, and with it what lies there.
void add_end_error(Ray ray, March m, float error, float t) {
  float moved = place_error(ray, m, t), depth = depth_in(m.piece, fraction_of(m.piece, m.offsets.above_low));
  vec2 range = range_of(m.corners);
  transmittance_at_turn = max(transmittance_at_turn, transmittance);
  add_error(moved > 0.5 ? 1.0 : opacity_of(extinction_scale * depth * moved));
  add_near_levels(m, error + 3.0 * moved * (range.y - range.x), moved);
}

// Where a part begins: the field may have turned, or the ray have begun, on the other side of a level.
void add_begin_error(Ray ray, March m, CellPart part, vec3 from, vec3 to, float length) {
  if (m.s == 0.0) value_error = value_error_in(m, from, to);
  float error = min(value_error, error_before), reach = length * share_within_error(part.p.x, 2.0 * part.p.y);
  if (m.is_first) add_end_error(ray, m, value_error, part.t);
  bool turns = m.is_first || part.rise * rise_before < 0.0;
  if (turns || (part.rise == 0.0 && value_error > 0.0)) add_near_levels(m, error, reach + reach_before);
  if (turns) transmittance_at_turn = transmittance;
}

// Where it meets a level: it may do so a little earlier or later, where the piece left and the piece entered, m.piece, have
// other materials, and a surface lies in front of, or behind, what is there.
void add_meeting_error(March m, TfPiece left, CellPart part, bool up, float target, float length, bool has_surface) {
  vec3 ahead = rise_from(part.p, part.size);
  value_error += abs(rise_at(part.p, part.size) - target);
  reach_before = length * share_within_error(ahead.x, 2.0 * ahead.y);
  float of_left = up ? 1.0 : 0.0, of_entered = 1.0 - of_left;
  float d0 = depth_in(left, of_left), d1 = depth_in(m.piece, of_entered), scale = extinction_scale * reach_before;
  vec3 colors = abs((left.low + left.rise * of_left - m.piece.low - m.piece.rise * of_entered).rgb);
  add_error(opacity_of(scale * (has_surface ? max(d0, d1) : abs(d0 - d1))) + greatest(colors) * opacity_of(scale * min(d0, d1)));
}

void end_part_error(CellPart part, bool meets, float length) {
  vec3 ahead = rise_from(part.p, part.size);
  if (!meets) reach_before = length * share_within_error(ahead.x, 2.0 * ahead.y);
  if (part.rise != 0.0) rise_before = part.rise;
  error_before = value_error;
}

#define BEGIN_ERRORS begin_errors()
#define ADD_BEGIN_ERROR(part, from, to, length) add_begin_error(ray, m, part, from, to, length)
#define ADD_MEETING_ERROR(left, part, up, target, length, has_surface) \
  add_meeting_error(m, left, part, up, target, length, has_surface)
#define END_PART_ERROR(part, meets, length) end_part_error(part, meets, length)
#define ADD_EXIT_ERROR add_end_error(ray, m, value_error, m.walk.t)
#else
#define BEGIN_ERRORS
#define ADD_BEGIN_ERROR(part, from, to, length)
#define ADD_MEETING_ERROR(left, part, up, target, length, has_surface)
#define END_PART_ERROR(part, meets, length)
#define ADD_EXIT_ERROR
#endif
