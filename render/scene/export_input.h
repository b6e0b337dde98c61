#pragma once

#include <glm/vec2.hpp>
#include <string>

#include "presets/exchange/exporters.h"
#include "render/volume/volume.h"

namespace crest {

/// What an exporter is given: the preset in the volume's values and units, its camera or the one that has the
/// whole volume in view, for a picture of `size`. `stem` is the files' name without extension, and the
/// preset's name where it has none. Without a volume `volume` is null. Throws Error, as ready_for_export.
ExportInput export_input(const Preset& preset, const Volume* volume, int rows, std::string stem,
                         glm::ivec2 size = {1024, 1024});

}  // namespace crest
