#pragma once

#include "ui/studio_state.h"

namespace crest {

/// The window for a file of another program: which of its presets, and whether its colours, its opacities or
/// both.
void import_dialog(StudioState& state, const StudioInputs& inputs, StudioRequests& requests);

/// "Both", "colours only", "opacities only", side by side.
void parts_choice(WidgetState& widgets, TfParts& take);

}  // namespace crest
