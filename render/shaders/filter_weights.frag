// What the texture unit makes of a ramp from 0 to 1 between two texels, and how far that is from the place itself: its
// weights may have 8 bits.

uniform sampler3D ramp;  // 2x2x2, 0 and 1 along x
uniform float places;    // of the target, side by side

out vec4 out_color;

void main() {
  float place = gl_FragCoord.x / places;
  vec3 across = vec3(0.25 + 0.5 * place, 0.25 + 0.5 * fract(13.0 * place), 0.25 + 0.5 * fract(7.0 * place));
  out_color = vec4(textureLod(ramp, across, 0.0).r - place, 0.0, 0.0, 1.0);
}
