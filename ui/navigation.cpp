#include "ui/navigation.h"

#include <imgui_internal.h>

#include <algorithm>
#include <utility>

#include "ui/keys.h"
#include "ui/style.h"
#include "ui/widgets.h"

namespace crest {
namespace {

ImGuiContext& context() { return *ImGui::GetCurrentContext(); }

bool enter_pressed() {
  return key_pressed(key::enter) || key_pressed(ImGui::GetKeyIndex(ImGuiKey_KeyPadEnter));
}

/// Arrows that nobody wants to move the focus by: while it is not shown, or where it is on what uses them.
void keep_arrows(const NavigationState& state) {
  ImGuiContext& g = context();
  const bool moves =
      g.NavMoveSubmitted && !(g.NavMoveFlags & (ImGuiNavMoveFlags_Tabbing | ImGuiNavMoveFlags_Forwarded));
  const bool is_theirs = state.was_visible && (state.takes_arrows == 0 || state.takes_arrows != g.NavId);
  if (!moves || is_theirs || state.popups > 0) return;
  g.NavInitRequest = g.NavInitRequestFromMove = false;
  ImGui::NavMoveRequestCancel();
  g.NavDisableHighlight = !state.was_visible;
}

/// Tab goes on from what has the focus, also where that is no field that is typed in, and shows where it
/// went.
void follow_tab(NavigationState& state) {
  ImGuiContext& g = context();
  if (state.was_tabbed && g.NavJustMovedToId != 0) {
    g.NavDisableHighlight = false;
    g.NavDisableMouseHover = true;
  }
  const bool tabs = g.NavMoveSubmitted && (g.NavMoveFlags & ImGuiNavMoveFlags_Tabbing);
  state.was_tabbed = tabs;
  if (tabs && g.NavTabbingDir == 0 && g.NavId != 0 && state.was_there) g.NavTabbingDir = +1;
}

/// Enter presses what has the focus, as Space does.
void activate_by_enter() {
  ImGuiContext& g = context();
  if (!enter_pressed() || !is_navigating() || g.ActiveId != 0) return;
  g.NavActivateId = g.NavActivateDownId = g.NavActivatePressedId = g.NavId;
}

/// Alt that is pressed and released without anything else.
bool is_alt_tapped(NavigationState& state) {
  const ImGuiIO& io = ImGui::GetIO();
  const bool had_alt = (io.KeyModsPrev & ImGuiKeyModFlags_Alt) != 0;
  if (io.KeyAlt && !had_alt) state.alt_alone = true;
  constexpr int left_alt = 342, right_alt = 346;
  for (int code = 0; code < IM_ARRAYSIZE(io.KeysDown); ++code)
    if (io.KeysDown[code] && code != left_alt && code != right_alt) state.alt_alone = false;
  const bool uses_mouse = ImGui::IsAnyMouseDown() || io.MouseWheel != 0 || io.MouseWheelH != 0;
  if (uses_mouse || io.KeyCtrl || io.KeyShift || io.AppFocusLost) state.alt_alone = false;
  if (io.KeyAlt || !had_alt) return false;
  return std::exchange(state.alt_alone, false);
}

}  // namespace

bool is_navigating() {
  const ImGuiContext& g = context();
  return g.NavId != 0 && !g.NavDisableHighlight && g.NavWindow;
}

void begin_navigation(NavigationState& state) {
  ImGui::PushItemFlag(ImGuiItemFlags_Inputable, true);  // Tab stops at all there is, not at fields alone
  keep_arrows(state);
  follow_tab(state);
  activate_by_enter();
  // Dear ImGui would show the focus on the panel around what had it
  if (key_pressed(key::escape) && state.popups == 0) context().NavDisableHighlight = true;
  if (is_alt_tapped(state) && state.popups == 0 && !ImGui::IsAnyItemActive()) state.asked_menu = true;
  state.takes_arrows = 0;
}

void end_navigation(NavigationState& state) {
  const ImGuiContext& g = context();
  ImGui::PopItemFlag();
  state.was_visible = is_navigating();
  state.was_there = g.NavIdIsAlive;
  state.popups = g.OpenPopupStack.Size;
}

void take_focus(NavigationState& state, Area area) {
  if (state.asked != area) return;
  ImGuiContext& g = context();
  ImGuiWindow* const window = g.CurrentWindow;
  ImGui::FocusWindow(window);
  ImGui::SetFocusID(g.LastItemData.ID, window);
  g.NavDisableHighlight = false;
  g.NavDisableMouseHover = true;
  state.area = area;
  state.asked = Area::none;
}

bool takes_arrows(NavigationState& state) {
  const ImGuiContext& g = context();
  if (!is_navigating() || g.NavId != g.LastItemData.ID) return false;
  state.takes_arrows = g.NavId;
  return true;
}

void keep_focus() {
  ImGui::NavMoveRequestCancel();
  context().NavDisableHighlight = true;
}

void show_focus(ImGuiID item, ImVec2 low, ImVec2 high) {
  ImGui::RenderNavHighlight({low, high}, item, ImGuiNavHighlightFlags_TypeThin);
}

bool default_button(const char* label, ImVec2 size) {
  ImGui::PushStyleVar(ImGuiStyleVar_FrameBorderSize, std::max(1.0F, scaled(1)));
  ImGui::PushStyleColor(ImGuiCol_Border, palette().accent);
  const bool pressed = ImGui::Button(label, size);
  ImGui::PopStyleColor();
  ImGui::PopStyleVar();
  ImGui::SetItemDefaultFocus();
  const ImGuiContext& g = context();
  const bool is_elsewhere = is_navigating() && g.NavId != g.LastItemData.ID;
  const bool is_free =
      !ImGui::IsWindowAppearing() && !ImGui::GetIO().WantTextInput && !ImGui::IsAnyItemActive();
  return pressed || (enter_pressed() && is_free && !is_elsewhere);
}

}  // namespace crest
