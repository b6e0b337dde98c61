#pragma once

#include "ui/studio_state.h"

namespace crest {

/// The height of the row, with the gap above it.
float time_step_row_height();

/// Under the views, while the volume has several time steps: which is shown, and what goes from one to
/// another.
void time_step_row(StudioState& state, const StudioInputs& inputs, StudioRequests& requests);

}  // namespace crest
