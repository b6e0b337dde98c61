#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <string>

#include "render/volume/convert.h"

namespace crest {

/// What 32-bit float loses of some values.
struct Rounding {
  double min = std::numeric_limits<double>::infinity(), max = -min;  ///< of the finite ones, before rounding
  std::size_t merged = 0;  ///< rounded where float32 numbers are further apart than the values
  double largest_change = 0;
};
Rounding joined(const Rounding& a, const Rounding& b);

/// Whether float32 may lose anything of values of this type, mapped.
bool may_round(ScalarType type, LinearMap map);

/// Of `count` values of `type`, `stride` values apart in `bytes`. Of integers, mapped, those count that lie
/// so far from zero that neighbours may become one.
Rounding rounding_of(std::span<const std::byte> bytes, ScalarType type, std::size_t count, std::size_t stride,
                     LinearMap map);

/// What a note says of it, or nothing: of doubles it is said only where their whole range has few float32
/// numbers.
std::string rounding_note(const Rounding& rounding, ScalarType type, LinearMap map);

}  // namespace crest
