#pragma once

#include "ui/studio_state.h"

namespace crest {

/// The window that offers the library's presets as they look on the open volume, once state.library.asked.
void library_window(StudioState& state, const StudioInputs& inputs, StudioRequests& requests);

}  // namespace crest
