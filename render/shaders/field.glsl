// The scalar field between the grid's points: that in which surfaces lie, by the filter ROOT_FIELD. DVR's samples have
// a field of their own, by DVR_FIELD, where that is another filter (OWN_ROOT_FILTER); else no place is evaluated twice.

#include "ray.glsl"
#include "statistics.glsl"

// Textures have one level, which is named wherever they are filtered: lanes that do not all take a branch know no
// derivatives.
uniform sampler3D volume;
uniform float texel_scale;
uniform vec3 texture_scale, texture_offset;  // from a position in the box to the texture: point i is at (i+0.5)/n

#if BRICKS
#include "bricks.glsl"
#else
ivec3 volume_points() { return textureSize(volume, 0); }
float texel_at(ivec3 point) { return texelFetch(volume, point, 0).r; }
float texel_between(vec3 place) { return textureLod(volume, place, 0.0).r; }
#endif

#if WHOLE_VALUES
// Texels of 16 bits are shares of texel_scale, and a little off the whole numbers that they stand for. These are met
// exactly at points, and between points that are equal.
float value_at_point(ivec3 point) { return round(texel_scale * texel_at(point)); }

float value_between(vec3 place) {
  const float rounding = 2.5e-7;  // of a share, and of the product: 2^-24 and 2^-23
  float value = texel_scale * texel_between(place), whole = round(value);
  return abs(value - whole) <= rounding * whole ? whole : value;
}
#else
float value_at_point(ivec3 point) { return texel_at(point); }

float value_between(vec3 place) { return texel_between(place); }
#endif

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
