// Macrocells (Knoll et al. 2009, section 6): a walk through them finds the spans of a ray in which something shows.

#include "walk.glsl"

#if SKIPPING || ADAPTIVE
// Of how many steps one is made in a macrocell; or, where nothing in it shows, how many macrocells away the nearest is in
// which something does, negative.
uniform isampler3D macrocells;
uniform vec3 macrocell_size;

// Spans are taken longer by more than places on the ray, and positions in the box, are rounded.
float slack_of(Ray ray, Span span) {
  vec3 size = max(abs(ray.origin), box_size);
  return 1.0e-6 * (max(abs(span.enter), abs(span.exit)) + max(size.x, max(size.y, size.z)));
}

int multiple_at(Walk walk) { return texelFetch(macrocells, walk.cell, 0).r; }

Walk begin_macrocells(Ray ray, Span span) {
  return begin_walk(ray, span, textureSize(macrocells, 0), macrocell_size);
}

// The next span of cells that show something and have the same multiple; false where there is none. `more` is whether the
// walk has a cell left.
bool next_macrocells(inout Walk walk, inout bool more, out Span span, out int multiple) {
  multiple = -1;
  bool goes_on = more;
  float enter = walk.t;
  while (goes_on) {
    int here = multiple_at(walk);
    goes_on = multiple <= 0 || here == multiple;
    if (multiple <= 0) enter = walk.t;
    if (goes_on) {
      multiple = here;
      more = goes_on = advance(walk, max(-here, 1));
    }
  }
  span = Span(enter, more ? walk.t : walk.end);
  return multiple > 0;
}
#endif
