#include "render/scene/export_input.h"

#include "render/scene/camera.h"
#include "render/volume/export_volume.h"

namespace crest {

ExportInput export_input(const Preset& preset, const Volume* volume, int rows, std::string stem,
                         glm::ivec2 size) {
  ExportInput input;
  input.rows = rows;
  input.size = size;
  input.name = preset.name.empty() ? stem : preset.name;
  input.stem = std::move(stem);
  if (volume) input.volume = export_volume(*volume);
  input.preset = ready_for_export(preset, input.volume);
  if (volume) input.preset.camera = camera_of(preset, volume->grid, aspect_of(size));
  return input;
}

}  // namespace crest
