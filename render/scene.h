#pragma once

#include <memory>

#include "presets/preset.h"
#include "render/volume/volume.h"

namespace crest {

/// What is rendered: a field, and a TF in the field's units.
struct Scene {
  std::shared_ptr<const Volume> volume;
  TransferFunction tf;  ///< resolved
  Rendering rendering;
};

/// The preset's TF and settings for a volume.
inline Scene make_scene(std::shared_ptr<const Volume> volume, const Preset& preset) {
  Scene scene;
  scene.tf = resolve(preset.transfer_function, volume->statistics.range, volume->grid.smallest_spacing());
  scene.rendering = preset.rendering;
  scene.volume = std::move(volume);
  return scene;
}

}  // namespace crest
