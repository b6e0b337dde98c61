#pragma once

#include "ui/studio_state.h"

namespace crest {

/// The window for StudioSettings, once it was asked for.
void settings_window(StudioState& state);

}  // namespace crest
