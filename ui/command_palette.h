#pragma once

#include "ui/actions.h"
#include "ui/studio_state.h"

namespace crest {

/// What fits what was typed, the best first, what cannot be done last; where nothing was typed all there is,
/// and first of it what was chosen last.
std::vector<PaletteRow> palette_rows(const ActionContext& context, std::string_view typed);

/// The window in which any action is found by its name. Returns whether it changed the document.
bool command_palette(const ActionContext& context);

}  // namespace crest
