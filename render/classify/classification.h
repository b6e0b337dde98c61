#pragma once

#include <vector>

#include "presets/peaks.h"
#include "presets/transfer_function.h"

namespace crest {

/// What an edit of the TF brings with it, for one field.
struct Classification {
  TransferFunction tf;         ///< resolved
  TransferFunction base;       ///< without the spikes that are shown as surfaces
  std::vector<Peak> peaks;     ///< all, to be listed
  std::vector<Peak> surfaces;  ///< those shown whose value the field can cross
};

/// `tf` is resolved; `field` is the volume's range. A surface at the field's minimum is left out: all is
/// inside it.
Classification classify(TransferFunction tf, ValueRange field);

}  // namespace crest
