#pragma once

#include <imgui.h>

namespace crest {

/// The colours that panels draw with themselves.
namespace palette {
inline constexpr ImU32 window = IM_COL32(22, 24, 28, 255);  ///< what the window is cleared to
inline constexpr ImU32 plot = IM_COL32(15, 16, 19, 255);
inline constexpr ImU32 grid = IM_COL32(255, 255, 255, 18);
inline constexpr ImU32 frame = IM_COL32(62, 66, 76, 255);
inline constexpr ImU32 histogram = IM_COL32(54, 62, 76, 255);
inline constexpr ImU32 curve = IM_COL32(226, 230, 236, 230);
inline constexpr ImU32 text = IM_COL32(216, 220, 226, 255);
inline constexpr ImU32 dim = IM_COL32(142, 149, 160, 255);
inline constexpr ImU32 faint = IM_COL32(96, 103, 114, 255);
inline constexpr ImU32 accent = IM_COL32(94, 166, 232, 255);
inline constexpr ImU32 good = IM_COL32(124, 214, 140, 255);
inline constexpr ImU32 warning = IM_COL32(238, 190, 90, 255);
inline constexpr ImU32 error = IM_COL32(240, 110, 96, 255);
}  // namespace palette

/// Sets Dear ImGui's current context up: colours, spacing, and the font at `scale` (1 = 96 dpi), which is
/// DejaVu Sans where the system has it. Call it before the font atlas is built. The program clears the window
/// to palette::window: the panels draw no background of their own.
void apply_style(float scale);

}  // namespace crest
