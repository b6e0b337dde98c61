#pragma once

#include "ui/studio_state.h"

namespace crest {

/// The sentences of changes_since() as a list, at most `most` of them; says how many more there are. They are
/// made anew where either preset is another than in the last frame.
void change_list(ChangeList& list, const Preset& saved, const Preset& now, std::size_t most);

/// What differs from the saved preset, and every step that can be gone to. Returns whether it changed the
/// document.
bool history_panel(Document& document, StudioState& state, const StudioInputs& inputs);

}  // namespace crest
