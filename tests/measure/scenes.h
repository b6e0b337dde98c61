#pragma once

#include "render/scene/scene.h"

namespace crest::testing {

/// A volume of 2^3 points with values from 0 to 1, and a TF that has nothing but a spike at `peak`.
inline Scene scene_with_peak(double peak) {
  auto volume = std::make_shared<Volume>();
  volume->grid.dims = {2, 2, 2};
  volume->values = std::vector<float>{0, 1, 0, 1, 0, 1, 0, 1};
  volume->statistics = compute_statistics(volume->grid, volume->values);
  Preset preset;
  for (const auto& [value, opacity] : {std::pair(peak - 0.001, 0.0), {peak, 0.5}, {peak + 0.001, 0.0}}) {
    ControlPoint point;
    point.value = value;
    point.opacity = opacity;
    preset.transfer_function.points.push_back(point);
  }
  return make_scene(volume, preset);
}

}  // namespace crest::testing
