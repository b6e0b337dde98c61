// The surfaces at the shown peaks' values.

struct Peak {
  vec4 color_opacity;
  float value;
};
layout(std430, binding = 0) readonly buffer Peaks { Peak peaks[]; };  // by ascending value
