// The scalar field between the grid's points: that in which surfaces lie, by the filter ROOT_FIELD. DVR's samples have
// a field of their own, by DVR_FIELD, where that is another filter (OWN_ROOT_FILTER); else no place is evaluated twice.

#include "ray.glsl"
#include "statistics.glsl"

// Textures have one level, which is named wherever they are filtered: lanes that do not all take a branch know no
// derivatives.
uniform sampler3D volume;
uniform vec3 texture_scale, texture_offset;  // from a position in the box to the texture: point i is at (i+0.5)/n

#if FILTER_LINEAR
#include "filter_linear.glsl"
#endif
#if FILTER_LINEAR_EXACT
#include "filter_linear_exact.glsl"
#endif
#if FILTER_BSPLINE
#include "filter_bspline.glsl"
#endif
#if FILTER_BC
#include "filter_bc.glsl"
#endif

float field(vec3 position) {
  COUNT_SAMPLE;
  return ROOT_FIELD(position);
}

// What DVR classifies at a position where the field of surfaces is known to have a value.
#if OWN_ROOT_FILTER
float dvr_field(vec3 position) {
  COUNT_SAMPLE;
  return DVR_FIELD(position);
}
#define DVR_VALUE(value, position) dvr_field(position)
#else
#define dvr_field field
#define DVR_VALUE(value, position) (value)
#endif
