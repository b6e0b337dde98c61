#pragma once

#include "ui/studio_state.h"

namespace crest {

/// The list of keys, and of what the mouse does.
void help_window(StudioState& state);

/// What the program is.
void about_window(StudioState& state, const std::string& version);

}  // namespace crest
