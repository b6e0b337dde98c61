// The gradients of the fields: the normal at a surface is that of the surfaces' field, in DVR that of DVR's.
#if SHADING
#include "field.glsl"

#if FILTER_GRADIENT
#define gradient ROOT_GRADIENT
#define dvr_gradient DVR_GRADIENT
#else

// Central differences over one voxel to either side, one-sided at the box's faces.
vec3 neighbour(vec3 position, int axis, float side) {
  position[axis] = clamp(position[axis] + side * cell_size[axis], 0.0, box_size[axis]);
  return position;
}

vec3 gradient(vec3 position) {
  vec3 result;
  for (int axis = 0; axis < 3; ++axis) {
    vec3 low = neighbour(position, axis, -1.0), high = neighbour(position, axis, 1.0);
    result[axis] = (ROOT_FIELD(high) - ROOT_FIELD(low)) / (high[axis] - low[axis]);
  }
  return result;
}

#if OWN_ROOT_FILTER
vec3 dvr_gradient(vec3 position) {
  vec3 result;
  for (int axis = 0; axis < 3; ++axis) {
    vec3 low = neighbour(position, axis, -1.0), high = neighbour(position, axis, 1.0);
    result[axis] = (DVR_FIELD(high) - DVR_FIELD(low)) / (high[axis] - low[axis]);
  }
  return result;
}
#else
#define dvr_gradient gradient
#endif
#endif
#endif
