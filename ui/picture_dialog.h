#pragma once

#include "ui/studio_state.h"

namespace crest {

/// The window in which a person says what a picture is to show and how large it is to be, before its file is
/// asked for.
void picture_dialog(Document& document, StudioState& state, const StudioInputs& inputs);

}  // namespace crest
