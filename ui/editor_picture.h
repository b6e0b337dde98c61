#pragma once

#include "ui/document.h"
#include "ui/editor_state.h"
#include "ui/studio.h"

namespace crest {

/// Draws the transfer-function editor as a picture that explains itself: the part of the plot that is in
/// sight, what lies behind the curve, peaks and points, and a title for either axis; nothing of what the
/// mouse does, or has selected. Over all of Dear ImGui's present frame, which is `size` large.
void draw_editor_picture(const Document& document, const EditorState& editor, const StudioInputs& inputs,
                         ImVec2 size);

}  // namespace crest
