#pragma once

#include <imgui.h>

#include <string>

namespace crest {

/// Keys as the GLFW backend numbers them; a letter or a digit is its (upper-case) ASCII code.
namespace key {
inline constexpr int escape = 256, enter = 257, tab = 258, backspace = 259, insert = 260, del = 261,
                     right = 262, left = 263, down = 264, up = 265, page_up = 266, page_down = 267,
                     home = 268, end = 269, f1 = 290, f5 = 294, f6 = 295, f10 = 299;
}

/// A key, and what must be held with it.
struct KeyChord {
  int key = 0;  ///< 0: none
  bool ctrl = false, shift = false, alt = false;
  bool operator==(const KeyChord&) const = default;
};

constexpr KeyChord ctrl_and(int key) { return {key, true, false, false}; }
constexpr KeyChord ctrl_shift_and(int key) { return {key, true, true, false}; }

/// "Ctrl+Shift+S"; nothing for no key.
std::string text_of(const KeyChord& chord);

/// Whether a key went down in this frame.
inline bool key_pressed(int key) { return ImGui::IsKeyPressed(key, false); }

/// Whether it went down in this frame with exactly what it is to be held with. With a digit Shift may be
/// held, too: some keyboards have their digits there.
bool is_pressed(const KeyChord& chord);

}  // namespace crest
