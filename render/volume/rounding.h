#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "render/volume/convert.h"

namespace crest {

/// What 32-bit float loses of the values: what a note says of it, or nothing. Of integers, mapped, those
/// count that lie so far from zero that neighbours may become one; of doubles it is said only where their
/// whole range has few float32 numbers. `bytes` and `stride` are as convert_to_float() has them.
std::string rounding_note(std::span<const std::byte> bytes, ScalarType type, std::size_t stride,
                          LinearMap map);

}  // namespace crest
