// The march of the post-shaded filters other than semi_transparent.

#include "blend_mode.glsl"

float ray_length;  // in the box

void march(Ray ray, Sampling s, int first, int last) {
  for (int i = first; i < last; ++i) {
    float t = middle_at(s, i), size = size_at(s, i);
    COUNT_DVR_SAMPLE;
    gather(dvr_field(at(ray, t)), DVR_LIGHT(t), size, size / ray_length);
    if (TERMINATED || transmittance == 0.0) break;
  }
}
