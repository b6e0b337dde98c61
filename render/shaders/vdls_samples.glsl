// What view-dependent layer sampling (VDLS) keeps of each ray between its passes, in two textures. Positions are in fixed
// point, units of `fixed_unit` smallest spacings; delta vectors have `fraction_bits` more, so that a sum of any number of
// them loses no digits.
//   layer samples: the ray's sample on the current layer; w has the fractions of its coordinates, ten bits each
//   delta vectors: from a layer's sample to the next one's (eq. 1); w is the ray's sample count

uniform float fixed_unit;   // a power of two
uniform int fraction_bits;  // at most 10: as many as the longest delta vector leaves room for

float delta_unit() { return ldexp(fixed_unit, -fraction_bits); }

ivec3 unpack_fraction(int packed_fraction) { return (ivec3(packed_fraction) >> ivec3(0, 10, 20)) & 1023; }
int pack_fraction(ivec3 fraction) { return fraction.x | fraction.y << 10 | fraction.z << 20; }
