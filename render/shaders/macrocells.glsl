// Macrocells (Knoll et al. 2009, section 6): a walk through them finds the spans of a ray in which something shows.

#include "walk.glsl"

#if SKIPPING || ADAPTIVE
// Negative where nothing shows in a macrocell, and for how many around it that is so; else of how many steps one is made
// there, or without ADAPTIVE, around how many macrocells something shows (resources/macrocell_texture.h).
uniform isampler3D macrocells;
uniform vec3 macrocell_size;

// Spans are taken longer by more than places on the ray, and positions in the box, are rounded.
float slack_of(Ray ray, Span span) {
  vec3 size = max(abs(ray.origin), box_size);
  return 1.0e-6 * (max(abs(span.enter), abs(span.exit)) + max(size.x, max(size.y, size.z)));
}

int macrocell_at(Walk walk) { return texelFetch(macrocells, walk.cell, 0).r; }

Walk begin_macrocells(Ray ray, Span span) {
  return begin_walk(ray, span, textureSize(macrocells, 0), macrocell_size);
}

#if ADAPTIVE
// The next span of cells that show something and have the same multiple; false where there is none. `more` is whether the
// walk has a cell left.
bool next_macrocells(inout Walk walk, inout bool more, out Span span, out int multiple) {
  multiple = 0;
  bool goes_on = more;
  float enter = walk.t;
  while (goes_on) {
    int here = macrocell_at(walk);
    if (multiple == 0) enter = walk.t;
    goes_on = multiple == 0 || here == multiple;
    if (goes_on) {
      multiple = max(here, 0);
      more = goes_on = advance(walk, max(-here, 1));
    }
  }
  span = Span(enter, more ? walk.t : walk.end);
  return multiple > 0;
}
#else
// The next span in which something shows, with no gap in it that is `least_gap` long; false where there is none. `more` is
// whether the walk has a cell left. One loop, with little in it: on SIMD hardware all lanes walk until the last one has
// found its span.
bool next_shown(inout Walk walk, inout bool more, float least_gap, out Span span) {
  const float none = 3.0e38;
  span = Span(none, none);
  while (more && (span.exit == none || walk.t < span.exit + least_gap)) {
    float t = walk.t;
    int here = macrocell_at(walk);
    more = advance(walk, abs(here));
    if (here > 0) span = Span(min(span.enter, t), min(walk.t, walk.end));
  }
  return span.exit != none;
}
#endif
#endif
