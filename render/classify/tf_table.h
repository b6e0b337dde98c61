#pragma once

#include <glm/vec4.hpp>
#include <vector>

#include "presets/transfer_function.h"

namespace crest {

/// A TF sampled for the GPU: colour, and extinction per smallest spacing, at equidistant values.
struct TfTable {
  ValueRange range;  ///< of the first and the last entry: float32 numbers, never the same
  std::vector<glm::vec4> entries;
};

/// Post-classification's table (Knoll et al. 2009, section 6), over the part of the TF's span that `field`
/// reaches: beyond it the TF is constant, or never asked for. `tf` is resolved.
TfTable build_tf_table(const TransferFunction& tf, ValueRange field, double smallest_spacing, int entries);

}  // namespace crest
