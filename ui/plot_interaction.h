#pragma once

#include "ui/plot.h"
#include "ui/studio_state.h"

namespace crest {

/// Mouse and keys over the plot, after its button (an InvisibleButton over plot and axis strip) was
/// submitted. `whole` is what the axis can show. Returns whether the transfer function changed.
bool handle_plot_mouse(TransferFunction& tf, EditorState& editor, const Plot& plot, ValueRange whole);
/// Nudges, deletes and selects; for when no text is being typed.
bool handle_plot_keys(TransferFunction& tf, EditorState& editor, const Plot& plot);

/// The width that a new peak gets: as typed, or a share of what is in sight, but no wider than a spike.
double new_peak_width(const TransferFunction& tf, const EditorState& editor, ValueRange visible);

/// Adds a peak in a colour of its own, selects it, and has its value typed.
bool add_peak(TransferFunction& tf, EditorState& editor, double value, double opacity, double width);

}  // namespace crest
