#pragma once

#include <optional>

#include "render/raycaster/need.h"

namespace crest {

/// What a picture is made from, whichever engine makes it: for people and statistics.
struct PictureNeed {
  FeatureList list;
  std::vector<GpuData> data;
  std::optional<double> tf_error;  ///< of the TF's table, where there is one (TfTableSize::error)
};

}  // namespace crest
