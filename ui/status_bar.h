#pragma once

#include "ui/studio_state.h"

namespace crest {

/// What is being read, with a button that stops it; the volume, what is under the mouse, the last message,
/// and the performance, in one line.
void status_bar(StudioState& state, const StudioInputs& inputs, StudioRequests& requests);

}  // namespace crest
