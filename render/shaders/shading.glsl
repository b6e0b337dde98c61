// A headlight, ambient and diffuse. Where the field is flat there is no surface to shade: full light.
#if SHADING
#include "field.glsl"

const float ambient = 0.25, diffuse = 0.75;
uniform float shading_strength;  // 1; 0 where shading is only measured

// `direction` is the ray's, of length 1; the normal may have any length.
float light(vec3 normal, vec3 direction) {
  float size = length(normal);
  float shaded = size > 0.0 ? ambient + diffuse * abs(dot(normal / size, direction)) : 1.0;
  return mix(1.0, shaded, shading_strength);
}
float light(Ray ray, float t) { return light(gradient(at(ray, t)), ray.direction); }
#define LIGHT(t) light(ray, t)
#else
#define LIGHT(t) 1.0
#endif
