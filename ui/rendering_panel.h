#pragma once

#include "ui/studio_state.h"

namespace crest {

/// How the pictures are made. Returns whether it changed the document.
bool rendering_panel(Document& document, StudioState& state, const StudioInputs& inputs,
                     StudioRequests& requests);

}  // namespace crest
