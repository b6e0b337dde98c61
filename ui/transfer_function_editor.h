#pragma once

#include "ui/plot.h"
#include "ui/studio_state.h"

namespace crest {

/// What is selected may be gone, after an undo or with another preset: drops it.
void trim_selection(EditorState& editor, const TransferFunction& tf);

/// To be called once a frame, before anything edits the TF in shown values (edit_shown).
void follow_shown_values(StudioState& state, const TransferFunction& stored, const StudioInputs& inputs);

/// The transfer function: fields of the selected point, the plot, and what the opacities mean. Returns
/// whether it changed the document.
bool transfer_function_editor(Document& document, StudioState& state, const StudioInputs& inputs);

/// Shows the selected points, or all there is.
void frame_selection(const Document& document, EditorState& editor, const StudioInputs& inputs);

/// What the value axis can show: the volume's range and the points, with a margin.
ValueRange axis_range(const TransferFunction& tf, const Volume* volume);
/// And what it shows.
ValueRange visible_values(const TransferFunction& tf, const EditorState& editor, const Volume* volume);

/// The editor's plot in a rectangle.
Plot make_plot(const EditorState& editor, ImVec2 corner, ImVec2 size, ValueRange visible);

/// What it shows of the transfer function and the volume, without points and what the mouse does.
void draw_plot_content(ImDrawList& list, const TransferFunction& tf, EditorState& editor, const Plot& plot,
                       const StudioInputs& inputs);

}  // namespace crest
