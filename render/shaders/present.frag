// A premultiplied picture over an opaque background; where it is smaller than what it is shown in, enlarged smoothly.

uniform sampler2D picture;
uniform vec3 background;
uniform vec2 scale;

out vec4 out_color;

vec4 texel(ivec2 at) { return texelFetch(picture, clamp(at, ivec2(0), textureSize(picture, 0) - 1), 0); }

vec4 enlarged() {
  vec2 place = gl_FragCoord.xy * scale - 0.5;
  ivec2 low = ivec2(floor(place));
  vec2 u = place - vec2(low);
  return mix(mix(texel(low), texel(low + ivec2(1, 0)), u.x), mix(texel(low + ivec2(0, 1)), texel(low + ivec2(1, 1)), u.x), u.y);
}

void main() {
  // Of the same size, what lies beside may not be drawn yet
  vec4 color = scale == vec2(1.0) ? texelFetch(picture, ivec2(gl_FragCoord.xy), 0) : enlarged();
  out_color = vec4(color.rgb + (1.0 - color.a) * background, 1.0);
}
