// A premultiplied picture over an opaque background, enlarged where it is smaller than what it is shown in.

uniform sampler2D picture;
uniform vec3 background;
uniform vec2 scale;

out vec4 out_color;

void main() {
  ivec2 texel = min(ivec2(gl_FragCoord.xy * scale), textureSize(picture, 0) - 1);
  vec4 color = texelFetch(picture, texel, 0);
  out_color = vec4(color.rgb + (1.0 - color.a) * background, 1.0);
}
