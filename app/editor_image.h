#pragma once

#include "render/files/image.h"
#include "ui/editor_picture.h"
#include "ui/palette.h"

namespace crest {

/// The transfer-function editor as a picture (ui/editor_picture.h), opaque. Text grows with its height: it is
/// as large as in a window of usual scale at 360 pixels. A GL 4.5 context must be current, and Dear ImGui's
/// own context, where there is one, stays as it is. Throws Error for a size that no picture has.
Image editor_image(const Document& document, const EditorState& editor, const StudioInputs& inputs,
                   glm::ivec2 size, Theme theme = Theme::dark);

}  // namespace crest
