// Trilinear, by the texture unit. Graphics hardware rounds its weights to 8 bits, which a sharp TF shows as stairs.
// (Its gradient is that of filter_linear_exact.glsl.)

float linear_field(vec3 position) { return value_between(position * texture_scale + texture_offset); }
