#pragma once

#include <optional>

#include "render/raycaster/need.h"

namespace crest {

/// What a picture is made from, what was left out, and what the graphics device holds for it, whichever
/// engine makes it.
struct PictureNeed {
  FeatureList features;
  std::vector<GpuData> gpu_data;
  std::optional<double> tf_error;  ///< of the TF's table, where there is one (TfTableSize::error)
  bool operator==(const PictureNeed&) const = default;
};

}  // namespace crest
