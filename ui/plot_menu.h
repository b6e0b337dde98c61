#pragma once

#include "ui/studio_state.h"

namespace crest {

/// The menu under the right mouse button, and the colour picker of a double-clicked point. Returns whether
/// they changed the transfer function.
bool plot_menus(Document& document, EditorState& editor, WidgetState& widgets, const StudioInputs& inputs,
                ValueRange visible);

}  // namespace crest
