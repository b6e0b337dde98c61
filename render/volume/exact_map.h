#pragma once

#include <cmath>

#include "render/volume/linear_map.h"

namespace crest {

/// Whether floats have all mapped values of 16 bits to the digit, and no two are one: then stored values
/// stand for them, and differences are so many slopes.
inline bool is_exact(LinearMap map) {
  constexpr double float_integers = 1 << 24, most_stored = 1 << 16;
  return map.slope != 0 && map.slope == std::round(map.slope) && map.intercept == std::round(map.intercept) &&
         std::abs(map.slope) * most_stored + std::abs(map.intercept) <= float_integers;
}

}  // namespace crest
