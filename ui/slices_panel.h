#pragma once

#include "ui/studio_state.h"

namespace crest {

/// Three slices that meet in a cursor, and what is there. Returns whether the document changed.
bool slices_panel(Document& document, StudioState& state, const StudioInputs& inputs,
                  StudioRequests& requests);

}  // namespace crest
