#pragma once

#include "ui/studio_state.h"

namespace crest {

/// The volume, what is under the mouse, the last message, and the performance, in one line.
void status_bar(const StudioState& state, const StudioInputs& inputs);

}  // namespace crest
