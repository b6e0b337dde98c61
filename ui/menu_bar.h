#pragma once

#include "ui/studio_state.h"

namespace crest {

/// The menus, with the preset's name at the right. Returns whether it changed the document.
bool menu_bar(Document& document, StudioState& state, const StudioInputs& inputs, StudioRequests& requests);

/// The keys of the menus, and those of the views. Returns whether they changed the document.
/// Whether a key is pressed for which a text that is being typed counts as finished: saving, quitting and
/// opening.
bool takes_typed_text();
bool shortcuts(Document& document, StudioState& state, const StudioInputs& inputs, StudioRequests& requests);

}  // namespace crest
