// Front to back, premultiplied.

vec4 collected = vec4(0.0);
float transmittance = 1.0;

// What is added to the one is taken from the other. Multiplying by 1 - alpha would round a faint alpha first, the same
// way each time; like this 1e5 contributions of 1e-5 keep a relative 1e-5 (crest stability).
void composite(vec3 color, float alpha) {
  float absorbed = transmittance * alpha;
  collected += absorbed * vec4(color, 1.0);
  transmittance -= absorbed;
}

// 1 - exp(-depth). The difference loses its digits for small depths, so these take the series.
float opacity_of(float optical_depth) {
  float x = optical_depth;
  return x < 0.01 ? x * (1.0 - x * (0.5 - x * (1.0 / 6.0 - x / 24.0))) : 1.0 - exp(-x);
}

// Its inverse, likewise. An opaque material has the depth that extinction is capped at.
float depth_of(float opacity) {
  float a = opacity;
  return a < 0.01 ? a * (1.0 + a * (0.5 + a * (1.0 / 3.0 + a * 0.25))) : -log(max(1.0 - a, 5.9604645e-8));
}
