// Some layers of a picture by VDLS, one after the other (sections 3.2, 3.3, 4.3): their samples are shaded, composited and
// blended with what the passes before left; the layer's samples move on.

#include "ray.glsl"
#include "field.glsl"
#include "transfer_function.glsl"
#include "compositing.glsl"
#include "shading.glsl"
#include "vdls_samples.glsl"

#if BACK_TO_FRONT
#define COMPOSITE composite_before
void composite_before(vec3 color, float alpha) {
  collected = alpha * vec4(color, 1.0) + (1.0 - alpha) * collected;
}
#endif
#include "blend_mode.glsl"

layout(location = 0) out vec4 out_color;
layout(location = 1) out ivec4 next_layer_sample;
uniform isampler2D layer_samples, delta_vectors;
uniform int first_layer;  // of this pass

#if GRADIENT_VOLUME
uniform sampler3D gradients;  // in any unit
vec3 gradient_at(vec3 position) {
  return textureLod(gradients, position * texture_scale + texture_offset, 0.0).xyz;
}
#elif SHADING
vec3 gradient_at(vec3 position) { return gradient(position); }
#endif

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  ivec4 delta = texelFetch(delta_vectors, pixel, 0);
#if EARLY_TEST
  if (first_layer >= delta.w) discard;  // outside of the volume
#endif
  ivec4 current = texelFetch(layer_samples, pixel, 0);
  ivec3 fraction = unpack_fraction(current.w);
  float dt = length(vec3(delta.xyz)) * delta_unit();
  collected = nothing_gathered;
#if SHADING
  Ray ray = pixel_ray();
#endif
  for (int layer = 0; layer < LAYERS; ++layer) {
    vec3 position = vec3(current.xyz) * fixed_unit;
    float value = field(position), lit = 1.0;
#if SHADING
    lit = light(ray, gradient_at(position));
#endif
    if (first_layer + layer < delta.w) gather(value, lit, dt, 1.0 / float(delta.w));
    ivec3 moved = fraction + delta.xyz;
    current.xyz += moved >> fraction_bits;
    fraction = moved & ((1 << fraction_bits) - 1);
  }
  current.w = pack_fraction(fraction);
  out_color = collected;
  next_layer_sample = current;
}
