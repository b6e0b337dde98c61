#pragma once

#include <string>

#include "ui/plot.h"
#include "ui/studio_state.h"

// What the editor's plot tells of a volume's values: a curve behind the transfer function, and the peaks that
// it suggests.

namespace crest {

/// A combo box for what lies behind the transfer function, as wide as its words, or as the room is.
void value_curve_choice(EditorState& editor, WidgetState& widgets, float room);

inline bool is_visibility(ValueCurve curve) {
  return curve == ValueCurve::visibility || curve == ValueCurve::log_visibility;
}

/// Draws it, or a word on why there is none; `to_domain` maps the volume's values to the axis.
void draw_value_curve(ImDrawList& list, const Plot& plot, EditorState& editor, const StudioInputs& inputs,
                      ValueMap to_domain);

/// What the curve has at a value of the volume's, for the status bar; empty where that is nothing.
std::string value_curve_text(const EditorState& editor, const StudioInputs& inputs, double value);

/// Marks on the value axis where the mean gradient by value is highest, but where a peak is already; a click
/// on one adds a spike there. After the plot's button was submitted, before the plot takes the mouse. Returns
/// whether the click is taken, and with it the transfer function changed.
bool suggested_peak_clicked(TransferFunction& tf, StudioState& state, const StudioInputs& inputs,
                            const Plot& plot, ValueMap to_domain);
void draw_suggested_peaks(ImDrawList& list, const EditorState& editor, const StudioInputs& inputs,
                          const Plot& plot, ValueMap to_domain);

}  // namespace crest
