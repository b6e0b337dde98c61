#pragma once

#include "ui/studio_state.h"

namespace crest {

/// The four modes side by side, or one of them enlarged, with one camera. Tells the size of each picture.
/// Returns whether it changed the document (its camera).
bool views_panel(Document& document, StudioState& state, const StudioInputs& inputs, StudioRequests& requests,
                 ImVec2 room);

}  // namespace crest
