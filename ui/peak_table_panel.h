#pragma once

#include "ui/studio_state.h"

namespace crest {

/// The peak table as a picture; the mouse tells what a cell holds.
void peak_table_panel(StudioState& state, const StudioInputs& inputs);

}  // namespace crest
