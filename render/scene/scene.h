#pragma once

#include <memory>

#include "presets/preset.h"
#include "render/volume/filter_bounds.h"
#include "render/volume/volume.h"

namespace crest {

/// What is rendered: a field, and a TF in the field's units.
struct Scene {
  std::shared_ptr<const Volume> volume;
  TransferFunction tf;  ///< resolved
  Rendering rendering;
};

/// What the scene's field can be, between the least and the greatest of the grid's values, or beyond them
/// where the filter has negative weights: in DVR samples, and where surfaces lie.
inline ValueRange dvr_range(const Scene& scene) {
  return field_range(dvr_filter(scene.rendering), scene.volume->statistics.range);
}
inline ValueRange surface_range(const Scene& scene) {
  return field_range(root_filter(scene.rendering), scene.volume->statistics.range);
}

/// The preset's TF and settings for a volume.
inline Scene make_scene(std::shared_ptr<const Volume> volume, const Preset& preset) {
  Scene scene;
  scene.tf = resolve(preset.transfer_function, volume->statistics.range, volume->grid.smallest_spacing());
  scene.rendering = preset.rendering;
  scene.volume = std::move(volume);
  return scene;
}

}  // namespace crest
