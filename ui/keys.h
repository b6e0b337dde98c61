#pragma once

#include <imgui.h>

namespace crest {

/// Keys that Dear ImGui 1.86 has no name for, as the GLFW backend numbers them; letters are their ASCII code.
inline constexpr int key_f1 = 290, key_f5 = 294;

/// Whether a key went down in this frame; `letter` is an upper-case letter or one of the above.
inline bool key_pressed(int letter) { return ImGui::IsKeyPressed(letter, false); }

}  // namespace crest
