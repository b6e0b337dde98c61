// Post-classification: the TF as a texture over the part of its span that the field reaches.

uniform sampler1D tf_texture;
uniform vec3 tf_min_scale_offset;  // the texture's coordinate is (value - x) * y + z: no digits are lost to a large offset

// Colour, and extinction per smallest spacing.
vec4 classify(float value) {
  float place = (value - tf_min_scale_offset.x) * tf_min_scale_offset.y + tf_min_scale_offset.z;
  return textureLod(tf_texture, place, 0.0);
}
