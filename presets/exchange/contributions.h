#pragma once

#include <vector>

#include "presets/peaks.h"
#include "presets/preset.h"

namespace crest {

/// What a preset shows by its mode, for targets that draw volumes and isosurfaces beside each other.
struct ShownContributions {
  TransferFunction dvr;        ///< without the spikes that are surfaces, in PEAK_XOR_DVR
  bool shows_dvr = true;       ///< else `dvr` is for looking at
  std::vector<Peak> surfaces;  ///< by value
};

ShownContributions shown_contributions(const Preset& preset);

}  // namespace crest
