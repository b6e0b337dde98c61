#pragma once

#include <imgui.h>

#include "presets/preset.h"
#include "render/volume/volume.h"

namespace crest {

/// The edges of the volume's box, faint, and its three axes with their names, over a view at `low`. Where it
/// is known which way they go in a patient, that is written at both ends: L and R, A and P, S and I.
void draw_outline(ImDrawList& list, const Camera& camera, const Volume& volume, ImVec2 low, ImVec2 size);

}  // namespace crest
