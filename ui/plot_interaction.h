#pragma once

#include "ui/plot.h"
#include "ui/studio_state.h"

namespace crest {

/// Mouse and keys over the plot, after its button (an InvisibleButton over plot and axis strip) was
/// submitted. `whole` is what the axis can show. Returns whether the transfer function changed.
bool handle_plot_mouse(TransferFunction& tf, EditorState& editor, const Plot& plot, ValueRange whole);
/// Nudges, deletes and selects; for when no text is being typed.
bool handle_plot_keys(TransferFunction& tf, EditorState& editor, const Plot& plot);

}  // namespace crest
