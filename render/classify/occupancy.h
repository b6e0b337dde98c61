#pragma once

#include <cstdint>
#include <vector>

#include "render/classify/peaks.h"
#include "render/classify/tf_table.h"
#include "render/volume/macrocells.h"

namespace crest {

/// Which macrocells may show something.
struct Occupancy {
  std::vector<std::uint8_t> cells;  ///< a macrocell each: 0 = nothing in it shows, 1 = it may
  double share = 1;                 ///< of those that may, of all
};

/// What a picture shows of a field.
struct Shown {
  const TransferFunction* tf = nullptr;         ///< resolved; null without DVR
  TableBlur blur = {};                          ///< of its table
  const std::vector<Peak>* surfaces = nullptr;  ///< by value; null without peaks
};

/// Looks up each macrocell in prefix sums over the values, in O(1). Conservative: a macrocell that shows
/// something is never 0; one that shows nothing may be 1.
Occupancy find_occupancy(const Macrocells& macrocells, const Shown& shown, ValueRange field);
/// Where either of two is 1.
Occupancy either(Occupancy a, const Occupancy& b);

/// How many steps are joined in each macrocell (Knoll et al. 2009, section 6.2): M = 2/m + 1, rounded down
/// and capped, where m is its standard deviation by that of the whole volume.
inline constexpr int most_joined_steps = 8;
std::vector<std::uint8_t> step_multiples(const Macrocells& macrocells, double volume_deviation);

}  // namespace crest
