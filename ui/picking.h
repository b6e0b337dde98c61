#pragma once

#include <imgui.h>

#include "ui/studio_state.h"

namespace crest {

/// What the mouse does in a view's picture, which was the last item, beside moving the camera: it tells the
/// value that it rests on; a click inspects the pixel's ray; a right click offers a peak at that value. `low`
/// and `size` are the picture's place, `pixels` its size as drawn. Returns whether the document changed.
bool pick_in_view(Document& document, StudioState& state, const StudioInputs& inputs,
                  StudioRequests& requests, int view, ImVec2 low, ImVec2 size, glm::ivec2 pixels);

}  // namespace crest
