// How much one picture differs from another, channel by channel: from black on, or about grey.

#include "over_backgrounds.glsl"

uniform float amplification;
uniform bool with_sign;

out vec4 out_color;

void main() {
  vec3 difference = amplification * difference_at(ivec2(gl_FragCoord.xy));
  out_color = vec4(with_sign ? 0.5 + 0.5 * difference : abs(difference), 1.0);
}
