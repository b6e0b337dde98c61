#pragma once

#include <imgui.h>

namespace crest {

// The studio without a mouse: Dear ImGui's navigation, where it does not do what people expect of Tab, Enter,
// Esc, Alt and the arrows. Dear ImGui 1.86 is told from outside, by its internal state.

/// Where F6 leads, one after the other.
enum class Area { none, views, editor, tabs };

struct NavigationState {
  Area area = Area::none;   ///< where F6 led last
  Area asked = Area::none;  ///< gets the focus when it is drawn next
  bool asked_menu = false;  ///< the first menu is to be opened
  // At the end of the last frame:
  bool was_visible = false;  ///< a widget was shown to have the focus
  bool was_there = false;    ///< and it was drawn
  bool was_tabbed = false;   ///< Tab moved it
  ImGuiID takes_arrows = 0;  ///< the item with the focus has a use of its own for the arrows
  int popups = 0;            ///< so many menus and windows that ask something were open
  bool alt_alone = false;    ///< Alt is held, and nothing else was pressed with it
};

/// To be called before and after all widgets of a frame. The first decides what its keys move; the second
/// notes what there was.
void begin_navigation(NavigationState& state);
void end_navigation(NavigationState& state);

/// Whether a widget is shown to have the focus, which is then what arrows, Space and Enter are for.
bool is_navigating();

/// Gives the last item the focus, where its area is asked for.
void take_focus(NavigationState& state, Area area);

/// Whether the last item has the focus, and so the arrows, which it uses itself.
bool takes_arrows(NavigationState& state);

/// What was pressed had a use of its own: it does not move the focus, which is no longer shown.
void keep_focus();

/// Shows that an item has the focus which Dear ImGui shows nothing of.
void show_focus(ImGuiID item, ImVec2 low, ImVec2 high);

/// The button of a dialog that Enter presses, as long as nothing is typed and no other widget has the focus.
/// It is marked, and has the focus at first.
bool default_button(const char* label, ImVec2 size);

}  // namespace crest
