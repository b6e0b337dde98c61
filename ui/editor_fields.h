#pragma once

#include "ui/studio_state.h"

namespace crest {

/// The rows of fields around the plot. Each returns whether it changed the transfer function.

/// Adds a peak or another shape, what can be done to points, and what the plot shows. `volume` is the
/// volume's range of values.
bool editor_toolbar(TransferFunction& tf, EditorState& editor, WidgetState& widgets, ValueRange volume,
                    ValueRange visible);
/// Exact numbers of the selected points. It stands above the plot, so that a click into the plot first takes
/// what was typed.
bool point_fields(TransferFunction& tf, EditorState& editor, WidgetState& widgets);
/// What one opacity means: the distance that absorbs it.
bool unit_fields(TransferFunction& tf, WidgetState& widgets);
/// What counts as a peak.
bool peak_rule_fields(TransferFunction& tf, WidgetState& widgets);

}  // namespace crest
