#pragma once

#include <imgui.h>

#include "presets/preset.h"
#include "render/volume/volume.h"

namespace crest {

/// The edges of the volume's box, faint, and its three axes with their names, over a view at `low`.
void draw_outline(ImDrawList& list, const Camera& camera, const Grid& grid, ImVec2 low, ImVec2 size);

}  // namespace crest
