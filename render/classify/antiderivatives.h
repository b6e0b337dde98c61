#pragma once

#include <array>
#include <glm/vec4.hpp>
#include <vector>

#include "presets/transfer_function.h"

namespace crest {

/// Pre-integration in one dimension, for steps of any length: the antiderivatives over the value of emission
/// (RGB, colour times extinction) and of extinction, both per smallest spacing. Along a segment on which the
/// field is linear from f0 to f1, the mean of either is a difference of its antiderivative over f1 - f0, and
/// the mean extinction gives the segment's opacity exactly.
///
/// That difference would cancel for near values. So an entry, which stands for a bin of values, holds the
/// bin's mean (in closed form: mean_material.h), and about it a line; and between entries the sum of all
/// means before it, in two floats. A segment then takes the line of the entry that it begins in, the
/// sums' difference, and the line of the entry that it ends in, all of them positive.
struct Antiderivatives {
  struct Entry {
    glm::vec4 mean;   ///< of the whole bin
    glm::vec4 slope;  ///< the material at x in [0, 1] of the bin is mean + (x - 1/2) * slope, never negative
    /// The means of all entries before, as a sum of two.
    glm::vec4 sum_high, sum_low;
  };
  ValueRange range;  ///< in float32
  /// The first is all values below the range, the last all above, both constant; between them equal bins.
  std::vector<Entry> entries;
};

/// Over the part of the TF in which it changes and that `field` reaches, in `bins` bins, at least 1, of
/// equal width. A spike narrower than a bin is spread over it, and keeps its integral. `tf` is resolved.
Antiderivatives build_antiderivatives(const TransferFunction& tf, ValueRange field, double smallest_spacing,
                                      int bins);

}  // namespace crest
