#pragma once

#include <imgui.h>

#include "ui/palette.h"

namespace crest {

/// The sizes of text: of everything, of what heads a part of a panel, of a page's name.
enum class TextSize { body, heading, title };

/// In pixels at scale 1. None is less than 13.
constexpr float pixels_of(TextSize size) {
  return size == TextSize::title ? 26.0F : size == TextSize::heading ? 16.0F : 14.0F;
}

/// Sets Dear ImGui's current context up: colours, spacing, and the fonts at `scale` (1 = 96 dpi), which are
/// DejaVu Sans where the system has it. Call it between frames; what holds the font atlas on the device has
/// to be made again. The program clears the window to palette().window: the panels draw no background of
/// their own.
void apply_style(float scale, Theme theme = Theme::dark);

/// For ImGui::PushFont().
ImFont* font_of(TextSize size);

}  // namespace crest
