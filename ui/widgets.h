#pragma once

#include <imgui.h>

#include <array>
#include <glm/vec3.hpp>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "presets/names.h"

namespace crest {

/// Where the named widgets stand in this frame, in pixels: for tests, and for scripts that drive the window.
using ItemRects = std::map<std::string, std::pair<ImVec2, ImVec2>, std::less<>>;

/// What is being typed into a number field and not yet taken.
struct TypedText {
  std::string text, shown;  ///< and what the field showed before
};
using TypedNumbers = std::unordered_map<ImGuiID, TypedText>;

/// What was typed into a number field and could not be taken.
struct RefusedNumber {
  ImGuiID field = 0;
  std::string text, why;
  std::string shown;      ///< what the field shows without it
  bool is_shown = false;  ///< in this frame
};

/// A field that is dragged, or typed in after a click.
struct FieldDrag {
  ImGuiID typed = 0;  ///< in which one types
  bool begin_typing = false;
  int frames = 0;   ///< until it must be active
  double from = 0;  ///< the number when the drag began
  bool moved = false;
};

/// What is typed before a field that was opened is ready for it, two frames later.
struct TypedAhead {
  ImGuiID field = 0;
  std::vector<ImWchar> characters;
  int frames = 0;  ///< that it still has
};

/// What the small widgets share.
struct WidgetState {
  ItemRects items;
  TypedNumbers typed;
  bool take_typed = false;    ///< in this frame what is typed is taken although nobody left its field
  bool number_taken = false;  ///< in this frame
  bool escape_taken = false;  ///< in this frame: what Esc was for is done
  std::optional<RefusedNumber> refused;
  FieldDrag drag;
  TypedAhead ahead;
};

/// Remembers the last item's place under `name`.
void note_item(WidgetState& state, std::string name);

/// Whether Esc is for the window that asks: no menu was closed by it, and no text is typed that it is about.
bool escape_pressed(const WidgetState& state);

/// For labels: six significant digits.
std::string short_text(double value);

/// A check box; `name` is its ID (give it "##"), and it is noted as an item. Returns whether the value
/// changed.
bool checkbox(WidgetState& state, const char* name, bool& value);

/// A slider between `limits`; Ctrl+click types a number. Returns whether the value changed.
bool slider(WidgetState& state, const char* name, double& value, ValueRange limits, float width);

/// A colour as a small square that opens a picker.
bool color_square(WidgetState& state, const char* name, glm::dvec3& color);
/// The picker alone, for a popup.
bool color_picker(const char* name, glm::dvec3& color);

/// The width of a combo box that shows this text whole.
float choice_width(const std::string& text);
/// A combo box over names; `value` counts them from 0, and is "mixed" beyond them. Where it is too narrow for
/// its text the arrow is left out.
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

/// A heading above what belongs together.
void heading(const char* text);
/// Text before a field, in line with it; dim.
void field_label(const char* text);
/// A tooltip for the last item.
void tip(const char* text);

/// The text, or as much of its beginning and end as fits, with dots between them.
std::string shortened(const std::string& text, float room);
/// The same as an item, whose tooltip has all of it.
void shortened_text(const std::string& text, float room, ImU32 color);

/// On a ground of its own, so that it can be read over any picture.
void text_on_picture(ImDrawList& list, ImVec2 at, const std::string& text);

ImU32 packed(glm::dvec3 color, double alpha = 1);
float scaled(float pixels);  ///< sizes are given for a font of 14 pixels

}  // namespace crest
