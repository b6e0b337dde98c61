#include "ui/keys.h"

#include <fmt/core.h>

#include <utility>

namespace crest {
namespace {

std::string name_of_key(int code) {
  constexpr std::pair<int, const char*> names[] = {{key::escape, "Esc"},      {key::enter, "Enter"},
                                                   {key::tab, "Tab"},         {key::backspace, "Backspace"},
                                                   {key::insert, "Insert"},   {key::del, "Delete"},
                                                   {key::right, "Right"},     {key::left, "Left"},
                                                   {key::down, "Down"},       {key::up, "Up"},
                                                   {key::page_up, "Page up"}, {key::page_down, "Page down"},
                                                   {key::home, "Home"},       {key::end, "End"}};
  for (const auto& [named, name] : names)
    if (named == code) return name;
  if (code >= key::f1 && code < key::f1 + 25) return fmt::format("F{}", code - key::f1 + 1);
  return std::string(1, char(code));
}

}  // namespace

std::string text_of(const KeyChord& chord) {
  if (chord.key == 0) return {};
  return fmt::format("{}{}{}{}", chord.ctrl ? "Ctrl+" : "", chord.alt ? "Alt+" : "",
                     chord.shift ? "Shift+" : "", name_of_key(chord.key));
}

bool is_pressed(const KeyChord& chord) {
  if (chord.key == 0 || !key_pressed(chord.key)) return false;
  const ImGuiIO& io = ImGui::GetIO();
  const bool is_digit = chord.key >= '0' && chord.key <= '9';
  return io.KeyCtrl == chord.ctrl && io.KeyAlt == chord.alt && (io.KeyShift == chord.shift || is_digit);
}

}  // namespace crest
