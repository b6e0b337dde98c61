#pragma once

#include <imgui.h>

#include <array>
#include <glm/vec3.hpp>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>

#include "presets/names.h"

namespace crest {

/// Where the named widgets stand in this frame, in pixels: for tests, and for scripts that drive the window.
using ItemRects = std::map<std::string, std::pair<ImVec2, ImVec2>, std::less<>>;

/// What is being typed into number fields and not yet taken, by widget.
using TypedNumbers = std::unordered_map<ImGuiID, std::string>;

/// What the small widgets share.
struct WidgetState {
  ItemRects items;
  TypedNumbers typed;
};

/// Remembers the last item's place under `name`.
void note_item(WidgetState& state, std::string name);

/// The shortest text that reads back as exactly this number.
std::string exact_text(double value);
/// For labels: six significant digits.
std::string short_text(double value);

/// A field for a number, shown and taken with full precision; Enter or leaving the field takes it, Escape
/// does not. What is no number is ignored, what is out of `limits` is moved to them. `name` is its ID (give
/// it
/// "##"); it is noted as an item. Returns whether the value changed.
bool number_field(WidgetState& state, const char* name, double& value, ValueRange limits, float width);
bool integer_field(WidgetState& state, const char* name, int& value, int least, int most, float width);

/// A check box; `name` is its ID (give it "##"), and it is noted as an item. Returns whether the value
/// changed.
bool checkbox(WidgetState& state, const char* name, bool& value);

/// A slider between `limits`; Ctrl+click types a number. Returns whether the value changed.
bool slider(WidgetState& state, const char* name, double& value, ValueRange limits, float width);

/// A colour as a small square that opens a picker.
bool color_square(WidgetState& state, const char* name, glm::dvec3& color);
/// The picker alone, for a popup.
bool color_picker(const char* name, glm::dvec3& color);

/// A combo box over names; `value` counts them from 0.
bool choice(WidgetState& state, const char* name, int& value, std::span<const std::string_view> names,
            float width);
/// A combo box over the values of an enum, by the names that they have in files.
template <NamedEnum Enum>
bool choice(WidgetState& state, const char* name, Enum& value, float width) {
  constexpr std::size_t count = std::size(EnumNames<Enum>::table);
  std::array<std::string_view, count> names;
  int index = 0;
  for (std::size_t i = 0; i < count; ++i) {
    names[i] = EnumNames<Enum>::table[i].name;
    if (EnumNames<Enum>::table[i].value == value) index = int(i);
  }
  if (!choice(state, name, index, names, width)) return false;
  value = EnumNames<Enum>::table[std::size_t(index)].value;
  return true;
}

/// Text before a field, in line with it; dim.
void field_label(const char* text);
/// A tooltip for the last item.
void tip(const char* text);

ImU32 packed(glm::dvec3 color, double alpha = 1);
float scaled(float pixels);  ///< sizes are given for a font of 14 pixels

}  // namespace crest
