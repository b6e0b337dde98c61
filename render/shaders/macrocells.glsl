// Macrocells (Knoll et al. 2009, section 6): a walk through them finds the spans of a ray in which something shows.

#include "walk.glsl"

#if SKIPPING || ADAPTIVE
uniform usampler3D macrocells;  // 0 = nothing in it shows; else of how many steps one is made there
uniform vec3 macrocell_size;

// Spans are taken longer by more than places on the ray, and positions in the box, are rounded.
float slack_of(Ray ray, Span span) {
  vec3 size = max(abs(ray.origin), box_size);
  return 1.0e-6 * (max(abs(span.enter), abs(span.exit)) + max(size.x, max(size.y, size.z)));
}

uint multiple_at(Walk walk) { return texelFetch(macrocells, walk.cell, 0).r; }

Walk begin_macrocells(Ray ray, Span span) {
  return begin_walk(ray, span, textureSize(macrocells, 0), macrocell_size);
}

// The next span of cells that show something and have the same multiple. `more` is whether the walk has a cell left.
bool next_macrocells(inout Walk walk, inout bool more, out Span span, out uint multiple) {
  while (more && multiple_at(walk) == 0u) more = advance(walk);
  span = Span(walk.t, walk.end);
  multiple = 0u;
  if (!more) return false;
  multiple = multiple_at(walk);
  do more = advance(walk);
  while (more && multiple_at(walk) == multiple);
  if (more) span.exit = walk.t;
  return true;
}
#endif
