// Front to back, premultiplied.

vec4 collected = vec4(0.0);
float transmittance = 1.0;

void composite(vec3 color, float alpha) {
  collected += transmittance * alpha * vec4(color, 1.0);
  transmittance *= 1.0 - alpha;
}

// 1 - exp(-depth). The difference loses its digits for small depths, so these take the series.
float opacity_of(float optical_depth) {
  float x = optical_depth;
  return x < 0.01 ? x * (1.0 - x * (0.5 - x * (1.0 / 6.0 - x / 24.0))) : 1.0 - exp(-x);
}
