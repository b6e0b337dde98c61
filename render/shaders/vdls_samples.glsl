// What view-dependent layer sampling (VDLS) keeps of each ray between its passes, in two textures. Positions are in fixed
// point, units of `fixed_unit` smallest spacings: a sum of hundreds of delta vectors loses no digits.
//   layer samples: the ray's sample on the current layer; w has the bits of its segments' length
//   delta vectors: from a layer's sample to the next one's (eq. 1); w is the ray's sample count

uniform float fixed_unit;  // a power of two
