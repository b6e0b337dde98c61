// The six post-shaded filters (VDLS, section 4.4 and Table 1): what a sample contributes to its ray. semi_transparent is the
// volume rendering integral; the paper's R = G = B = alpha = D is that of a grey ramp.

#include "compositing.glsl"

#ifndef COMPOSITE
#define COMPOSITE composite
#endif

uniform vec2 value_min_scale;    // D = (value - x) * y runs from 0 to 1 over the volume's range
uniform float iso_extinction;    // iso_surface: a sample that absorbs no less is opaque and white
uniform float sample_thickness;  // lookup: what a sample stands for, whatever the step: the TF's unit distance

// What is there before the first sample, to be combined with it.
const vec4 nothing_gathered = vec4(BLEND_MINIMUM);

// `light` is the shading's, `size` that of the sample's segment, and `share` what that is of the ray.
void gather(float value, float light, float size, float share) {
#if BLEND_MAXIMUM || BLEND_MINIMUM || BLEND_MEAN
  vec4 grey = vec4(vec3(clamp((value - value_min_scale.x) * value_min_scale.y, 0.0, 1.0)), 1.0);
#if BLEND_MAXIMUM
  collected = max(collected, grey);
#elif BLEND_MINIMUM
  collected = min(collected, grey);
#else
  collected += share * grey;
#endif
#else
  vec4 material = classify(value);
#if BLEND_ISO_SURFACE
  COMPOSITE(vec3(light), float(material.a >= iso_extinction));
#elif BLEND_LOOKUP
  COMPOSITE(material.rgb * light, opacity_of(material.a * sample_thickness));
#elif BLEND_SEMI_TRANSPARENT
  COMPOSITE(material.rgb * light, opacity_of(material.a * size));
#else
#error The blend mode is not known here.
#endif
#endif
}
