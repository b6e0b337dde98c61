// How much one picture differs from another in a block of pixels: the greatest difference of a channel, the sum of their
// squares, and how many pixels are off by more than `least`.

#include "over_backgrounds.glsl"

uniform float least;

out vec4 out_color;

void main() {
  ivec2 size = textureSize(picture_a, 0), first = BLOCK * ivec2(gl_FragCoord.xy);
  float most = 0.0, squares = 0.0, off = 0.0;
  for (int i = 0; i < BLOCK * BLOCK; ++i) {
    ivec2 at = first + ivec2(i % BLOCK, i / BLOCK);
    bool is_inside = all(lessThan(at, size));
    vec3 difference = is_inside ? abs(difference_at(min(at, size - 1))) : vec3(0.0);
    float channel = max(difference.r, max(difference.g, difference.b));
    most = max(most, channel);
    squares += dot(difference, difference);
    off += channel > least ? 1.0 : 0.0;
  }
  out_color = vec4(most, squares, off, 1.0);
}
