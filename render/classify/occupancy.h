#pragma once

#include <cstdint>
#include <vector>

#include "presets/peaks.h"
#include "render/classify/tf_table.h"
#include "render/volume/macrocells.h"

namespace crest {

/// Which macrocells may show something.
struct Occupancy {
  std::vector<std::uint8_t> cells;  ///< a macrocell each: 0 = nothing in it shows, 1 = it may
  double share = 1;                 ///< of those that may, of all
};

/// What a picture shows of a field: the materials of a TF, or surfaces at their values, or both.
struct Shown {
  const TransferFunction* tf = nullptr;         ///< the TF of the DVR, resolved; null without DVR
  TableBlur blur = {};                          ///< how far the TF's table spreads a value's material
  const std::vector<Peak>* surfaces = nullptr;  ///< the surfaces, by ascending value; null without peaks
};

/// Finds the macrocells that may show something, each in O(1) by prefix sums over the values. Conservative: a
/// macrocell that shows something is never 0, and one that shows nothing may be 1.
Occupancy find_occupancy(const Macrocells& macrocells, const Shown& shown, ValueRange field);
/// Marks the macrocells that either of two marks.
Occupancy either(Occupancy a, const Occupancy& b);

/// How many steps are joined in each macrocell (Knoll et al. 2009, section 6.2): M = 2/m + 1, rounded down
/// and capped, where m is its standard deviation by that of the whole volume.
inline constexpr int most_joined_steps = 8;
std::vector<std::int8_t> step_multiples(const Macrocells& macrocells, double volume_deviation);

}  // namespace crest
