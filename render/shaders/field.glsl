// The scalar field: trilinear between the grid's points, by the texture unit.

#include "ray.glsl"
#include "statistics.glsl"

uniform sampler3D volume;
uniform vec3 texture_scale, texture_offset;  // from a position in the box to the texture: point i is at (i+0.5)/n

float field(vec3 position) {
  COUNT_SAMPLE;
  return texture(volume, position * texture_scale + texture_offset).r;
}

#if SHADING

// Central differences over one voxel to either side, one-sided at the box's faces.
vec3 gradient(vec3 position) {
  vec3 result;
  for (int axis = 0; axis < 3; ++axis) {
    vec3 low = position, high = position;
    low[axis] = max(position[axis] - cell_size[axis], 0.0);
    high[axis] = min(position[axis] + cell_size[axis], box_size[axis]);
    result[axis] = (texture(volume, high * texture_scale + texture_offset).r -
                    texture(volume, low * texture_scale + texture_offset).r) /
                   (high[axis] - low[axis]);
  }
  return result;
}
#endif
