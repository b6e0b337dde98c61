#pragma once

#include <vector>

#include "presets/transfer_function.h"
#include "render/classify/peak_table.h"
#include "render/classify/peaks.h"

namespace crest {

/// What an edit of the TF brings with it, for one field.
struct Classification {
  TransferFunction tf;         ///< resolved
  std::vector<Peak> peaks;     ///< all, to be listed
  std::vector<Peak> surfaces;  ///< those shown whose value the field can cross
  PeakTable table;             ///< of `surfaces`
};

/// `tf` is resolved; `field` is the volume's range. A surface at the field's minimum is left out: all is
/// inside it.
Classification classify(TransferFunction tf, ValueRange field, int bins);

}  // namespace crest
