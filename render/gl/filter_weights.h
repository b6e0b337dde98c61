#pragma once

#include <epoxy/gl.h>

namespace crest::gl {

/// How far a weight of the texture unit's linear filter may be off, measured: 2^-9 where weights have 8 bits,
/// as on most graphics hardware, and 0 where they are as good as 32-bit float makes them. Of textures of this
/// format, whose values reach from 0 to 1. Draws 4096 pixels into a target that stays bound, and waits for
/// them. Throws Error when the driver fails.
double measure_weight_error(GLenum format = GL_R32F);

/// The bits of weights that are rounded so far: 8 for 2^-9.
int weight_bits(double weight_error);

}  // namespace crest::gl
