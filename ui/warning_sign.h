#pragma once

#include <span>
#include <string>

#include "ui/widgets.h"

namespace crest {

/// A triangle as high as a line of text, with the warnings as its tooltip. It is noted as an item under
/// `name`.
void warning_sign(WidgetState& state, std::string name, std::span<const std::string> warnings);

/// The sign alone, `size` pixels wide, on a ground of this colour.
void draw_warning_sign(ImDrawList& list, ImVec2 low, float size, ImU32 color, ImU32 ground);

}  // namespace crest
