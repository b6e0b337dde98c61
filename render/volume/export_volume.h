#pragma once

#include "presets/exchange/exporters.h"
#include "render/volume/volume.h"

namespace crest {

/// What an exporter is to know of a volume.
ExportVolume export_volume(const Volume& volume);

}  // namespace crest
