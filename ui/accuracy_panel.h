#pragma once

#include "ui/studio_state.h"

namespace crest {

/// Error against run time, as it is measured in the background: a diagram for each exact answer, and what
/// each method makes of it. Returns whether the document changed: a click on a point takes its setting.
bool accuracy_panel(Document& document, StudioState& state, const StudioInputs& inputs,
                    StudioRequests& requests);

}  // namespace crest
