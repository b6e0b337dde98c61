#pragma once

#include "ui/studio_state.h"

namespace crest {

/// The table of all control points: value, opacity, colour and surface, each to be edited alone; a click on a
/// row selects its point, with Ctrl or Shift several. Returns whether it changed the transfer function.
bool points_panel(TransferFunction& tf, EditorState& editor, WidgetState& widgets);

}  // namespace crest
