#pragma once

#include "ui/studio_state.h"

namespace crest {

/// Puts the selected points on the clipboard, as JSON.
void copy_points(const TransferFunction& tf, const EditorState& editor);

/// Take the selected points away; the first puts them on the clipboard before. Return whether there were any.
bool cut_points(TransferFunction& tf, EditorState& editor);
bool delete_points(TransferFunction& tf, EditorState& editor);

/// Adds the points of the clipboard and selects them; where the same ones stand already, beside them, and
/// their value is to be typed. `volume` maps them to the domain of the TF; `visible` is what of it is in
/// sight. Returns whether there were any; else editor.note tells why not.
bool paste_points(TransferFunction& tf, EditorState& editor, ValueRange volume, ValueRange visible);

}  // namespace crest
