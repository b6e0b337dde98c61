// Two pictures, each over its background.

uniform sampler2D picture_a, picture_b;
uniform vec3 background_a, background_b;

vec3 over(sampler2D picture, vec3 background, ivec2 at) {
  vec4 color = texelFetch(picture, at, 0);
  return color.rgb + (1.0 - color.a) * background;
}

vec3 difference_at(ivec2 at) { return over(picture_b, background_b, at) - over(picture_a, background_a, at); }
