#pragma once

#include "ui/studio_state.h"

namespace crest {

/// "3 minutes ago".
std::string age_text(double seconds);

/// A line over everything, while an earlier run of the program left unsaved changes.
void recovery_banner(StudioState& state, const StudioInputs& inputs, StudioRequests& requests);

}  // namespace crest
