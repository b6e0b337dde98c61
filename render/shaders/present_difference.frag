// How much one picture differs from another, channel by channel: from black on, or about grey.

uniform sampler2D picture_a, picture_b;
uniform vec3 background_a, background_b;
uniform float amplification;
uniform bool with_sign;

out vec4 out_color;

vec3 color_of(sampler2D picture, vec3 background) {
  vec4 color = texelFetch(picture, ivec2(gl_FragCoord.xy), 0);
  return color.rgb + (1.0 - color.a) * background;
}

void main() {
  vec3 difference = amplification * (color_of(picture_b, background_b) - color_of(picture_a, background_a));
  out_color = vec4(with_sign ? 0.5 + 0.5 * difference : abs(difference), 1.0);
}
