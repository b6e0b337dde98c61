// A headlight, ambient and diffuse. Where the field is flat there is no surface to shade: full light.
#if SHADING
#include "gradient.glsl"

const float ambient = 0.25, diffuse = 0.75;
uniform float shading_strength;  // 1; 0 where shading is only measured

float light(Ray ray, vec3 normal) {
  float size = length(normal);
  float shaded = size > 0.0 ? ambient + diffuse * abs(dot(normal / size, ray.direction)) : 1.0;
  return mix(1.0, shaded, shading_strength);
}
#define LIGHT(t) light(ray, gradient(at(ray, t)))
#define DVR_LIGHT(t) light(ray, dvr_gradient(at(ray, t)))
#else
#define LIGHT(t) 1.0
#define DVR_LIGHT(t) 1.0
#endif
