// How far each pixel may be off, at most, in the colours of all error pictures (scene/error_colors.h).

uniform usampler2D counts;
uniform vec3 error_scale[ERROR_COLORS];
uniform vec2 shown_errors;  // of the first and the last colour

out vec4 out_color;

void main() {
  float bound = uintBitsToFloat(texelFetch(counts, ivec2(gl_FragCoord.xy), 0).w & 0x7fffffffu);
  float height = log(max(bound, shown_errors.x) / shown_errors.x) / log(shown_errors.y / shown_errors.x);
  float place = clamp(height, 0.0, 1.0) * float(ERROR_COLORS - 1);
  int below = min(int(place), ERROR_COLORS - 2);
  out_color = vec4(mix(error_scale[below], error_scale[below + 1], place - float(below)), 1.0);
}
