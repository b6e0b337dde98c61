#include "ui/studio.h"

#include <fmt/core.h>
#include <imgui_internal.h>

#include <algorithm>
#include <cmath>

#include "ui/accuracy_panel.h"
#include "ui/actions.h"
#include "ui/command_palette.h"
#include "ui/edit_shown.h"
#include "ui/error_banner.h"
#include "ui/export_dialog.h"
#include "ui/help_window.h"
#include "ui/history_panel.h"
#include "ui/import_dialog.h"
#include "ui/library_window.h"
#include "ui/menu_bar.h"
#include "ui/opening_dialog.h"
#include "ui/peak_table_panel.h"
#include "ui/peaks_panel.h"
#include "ui/picture_dialog.h"
#include "ui/points_panel.h"
#include "ui/preset_details.h"
#include "ui/questions.h"
#include "ui/ray_panel.h"
#include "ui/recovery_banner.h"
#include "ui/rendering_panel.h"
#include "ui/settings_window.h"
#include "ui/shown_values.h"
#include "ui/slices_panel.h"
#include "ui/start_page.h"
#include "ui/status_bar.h"
#include "ui/style.h"
#include "ui/time_step_row.h"
#include "ui/transfer_function_editor.h"
#include "ui/value_curves.h"
#include "ui/views_panel.h"

namespace crest {
namespace {

constexpr float least_window = 64;   // pixels; a smaller one is minimized
constexpr double wheel_pause = 0.4;  // seconds after which a turn of the wheel is over

constexpr ImGuiWindowFlags fixed_window =
    ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoBackground |
    ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoSavedSettings |
    ImGuiWindowFlags_NoScrollWithMouse;
constexpr ImGuiWindowFlags fixed_child =
    ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse | ImGuiWindowFlags_NavFlattened;

/// The gap between two parts, which drags `share` of `length` pixels with it; `sign` is -1 where the part
/// that has the share lies behind the gap.
void splitter(const char* name, bool upright, float sign, float& share, float length) {
  const float gap = scaled(8);
  const ImVec2 at = ImGui::GetCursorScreenPos(), room = ImGui::GetContentRegionAvail();
  const ImVec2 size = upright ? ImVec2(gap, std::max(room.y, 1.0F)) : ImVec2(std::max(room.x, 1.0F), gap);
  ImGui::InvisibleButton(name, size);
  const bool held = ImGui::IsItemActive(), near = ImGui::IsItemHovered() || held;
  if (near) ImGui::SetMouseCursor(upright ? ImGuiMouseCursor_ResizeEW : ImGuiMouseCursor_ResizeNS);
  const ImVec2 delta = ImGui::GetIO().MouseDelta;
  if (held) share += sign * (upright ? delta.x : delta.y) / length;
  const ImU32 color = near ? palette().accent : palette().frame;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float middle = std::floor(gap / 2);
  if (upright)
    list.AddRectFilled({at.x + middle, at.y}, {at.x + middle + 1, at.y + size.y}, color);
  else
    list.AddRectFilled({at.x, at.y + middle}, {at.x + size.x, at.y + middle + 1}, color);
}

bool peaks_and_table(Document& document, StudioState& state, const StudioInputs& inputs) {
  const float height = ImGui::GetContentRegionAvail().y;
  const float rows = float(inputs.peaks.size()) + 1;
  const float list = std::min(rows * (ImGui::GetFrameHeight() + scaled(10)), height * 0.42F);
  const bool changed = peaks_panel(document, state, inputs, std::max(list, scaled(60)));
  ImGui::Spacing();
  peak_table_panel(document, state, inputs);
  return changed;
}

/// One of the tabs; `panel` draws what is in it, and returns whether it changed the document.
template <class Panel>
bool tab(StudioState& state, const char* name, Panel&& panel) {
  const bool comes_up = state.asked_tab == name;
  if (comes_up) state.asked_tab = {};
  const bool open = ImGui::BeginTabItem(name, nullptr, comes_up ? ImGuiTabItemFlags_SetSelected : 0);
  note_item(state.widgets, fmt::format("tab/{}", name));
  if (!open) return false;
  take_focus(state.navigation, Area::tabs);
  const bool changed = panel();
  ImGui::EndTabItem();
  return changed;
}

bool tabs(Document& document, StudioState& state, const StudioInputs& inputs, StudioRequests& requests) {
  if (!ImGui::BeginTabBar("panels")) return false;
  bool changed = tab(state, "Peaks", [&] {
    return in_shown_values(document, state, inputs, [&] { return peaks_and_table(document, state, inputs); });
  });
  changed |= tab(state, "Points", [&] {
    return in_shown_values(document, state, inputs, [&] {
      return points_panel(document.preset.transfer_function, state.editor, state.widgets);
    });
  });
  changed |= tab(state, "Rendering", [&] { return rendering_panel(document, state, inputs, requests); });
  changed |= tab(state, "Accuracy", [&] { return accuracy_panel(document, state, inputs, requests); });
  changed |= tab(state, "Slices", [&] { return slices_panel(document, state, inputs, requests); });
  changed |= tab(state, "Ray", [&] { return ray_panel(document, state, inputs), false; });
  changed |= tab(state, "History", [&] { return history_panel(document, state, inputs); });
  ImGui::EndTabBar();
  return changed;
}

bool side(Document& document, StudioState& state, const StudioInputs& inputs, StudioRequests& requests) {
  const float height = ImGui::GetContentRegionAvail().y;
  float& share = state.layout.editor_share;
  share = std::clamp(share, 0.25F, 0.80F);
  ImGui::BeginChild("editor", {0, std::floor(height * share)}, false, fixed_child);
  bool changed = in_shown_values(document, state, inputs,
                                 [&] { return transfer_function_editor(document, state, inputs); });
  ImGui::EndChild();
  splitter("##editor height", false, 1, share, height);
  ImGui::BeginChild("tabs", {0, 0}, false, ImGuiWindowFlags_NavFlattened);
  changed |= tabs(document, state, inputs, requests);
  ImGui::EndChild();
  return changed;
}

bool views_and_steps(Document& document, StudioState& state, const StudioInputs& inputs,
                     StudioRequests& requests) {
  const float row = inputs.steps ? time_step_row_height() : 0;
  const ImVec2 corner = ImGui::GetCursorPos(), room = ImGui::GetContentRegionAvail();
  const bool changed = views_panel(document, state, inputs, requests, {room.x, std::max(room.y - row, 1.0F)});
  ImGui::SetCursorPos({corner.x, corner.y + room.y - row + scaled(8)});
  time_step_row(state, inputs, requests);
  return changed;
}

bool main_area(Document& document, StudioState& state, const StudioInputs& inputs, StudioRequests& requests,
               float height) {
  const float width = ImGui::GetContentRegionAvail().x;
  float& share = state.layout.side_share;
  const float least = std::min(scaled(484) / width, 0.6F);
  share = std::clamp(share, least, std::max(least, 0.7F));
  const float side_width = std::floor(width * share);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, 0});
  ImGui::BeginChild("main", {0, height}, false, fixed_child);
  ImGui::BeginChild("views", {width - side_width - scaled(16), 0}, false, fixed_child);
  ImGui::PopStyleVar();
  bool changed = false;
  if (!inputs.volume && inputs.loading.empty() && document.volume_source.empty())
    start_page(document, state, inputs, requests);
  else
    changed |= views_and_steps(document, state, inputs, requests);
  ImGui::EndChild();
  error_banner(state, inputs, requests, ImGui::GetItemRectMin(), ImGui::GetItemRectSize().x);
  ImGui::SameLine(0, scaled(4));
  splitter("##side width", true, -1, share, width);
  ImGui::SameLine(0, scaled(4));
  ImGui::BeginChild("side", {0, 0}, false, fixed_child);
  changed |= side(document, state, inputs, requests);
  ImGui::EndChild();
  ImGui::EndChild();
  return changed;
}

bool studio_window(Document& document, StudioState& state, const StudioInputs& inputs,
                   StudioRequests& requests) {
  const ImGuiViewport& viewport = *ImGui::GetMainViewport();
  ImGui::SetNextWindowPos(viewport.WorkPos);
  ImGui::SetNextWindowSize(viewport.WorkSize);
  ImGui::Begin("studio", nullptr, fixed_window);
  recovery_banner(state, inputs, requests);
  const float status = ImGui::GetFontSize() + ImGui::GetStyle().ItemSpacing.y;
  const float height = std::max(ImGui::GetContentRegionAvail().y - status, 1.0F);
  const bool changed = main_area(document, state, inputs, requests, height);
  status_bar(state, inputs, requests);
  ImGui::End();
  return changed;
}

/// Of the peak under the mouse in the list, unless something is pressed or typed there.
std::optional<std::pair<std::size_t, std::size_t>> lit_points(const StudioState& state,
                                                              const StudioInputs& inputs) {
  const auto hovered = state.editor.hovered_peak;
  if (!hovered || *hovered >= inputs.peaks.size() || ImGui::IsAnyItemActive()) return std::nullopt;
  const Peak& peak = inputs.peaks[*hovered];
  if (!peak.shown) return std::nullopt;
  return std::pair{peak.first_point, peak.last_point};
}

/// Whether the person is in the middle of an edit, which is one step when it ends.
bool is_editing(const StudioState& state) {
  if (ImGui::IsAnyItemActive() || ImGui::IsAnyMouseDown()) return true;
  for (const ImGuiKey key : {ImGuiKey_LeftArrow, ImGuiKey_RightArrow, ImGuiKey_UpArrow, ImGuiKey_DownArrow})
    if (ImGui::IsKeyDown(ImGui::GetKeyIndex(key))) return true;
  return state.camera_moved >= 0 && ImGui::GetTime() - state.camera_moved < wheel_pause;
}

/// Esc closes the menu that was opened last; windows that ask something deal with it themselves.
void close_menu_by_key(StudioState& state) {
  const ImGuiContext& context = *ImGui::GetCurrentContext();
  if (context.OpenPopupStack.Size < state.navigation.popups)
    state.widgets.escape_taken = true;  // Dear ImGui closed it
  if (state.widgets.escape_taken) return;
  if (context.OpenPopupStack.empty() || ImGui::IsAnyItemActive()) return;
  if (!key_pressed(key::escape)) return;
  const ImGuiWindow* window = context.OpenPopupStack.back().Window;
  if (!window || (window->Flags & ImGuiWindowFlags_Modal)) return;
  ImGui::ClosePopupToLevel(context.OpenPopupStack.Size - 1, true);
  state.widgets.escape_taken = true;
}

}  // namespace

void StudioStateDeleter::operator()(StudioState* state) const { delete state; }

StudioStatePtr make_studio_state() { return StudioStatePtr(new StudioState); }

StudioRequests studio_frame(Document& document, StudioState& state, const StudioInputs& inputs) {
  StudioRequests requests;
  state.widgets.items.clear();
  state.under_cursor.clear();
  state.widgets.escape_taken = false;
  const ImVec2 display = ImGui::GetIO().DisplaySize;
  if (display.x < least_window || display.y < least_window) {
    requests.quit = inputs.close_requested && !inputs.unsaved_changes;
    return requests;
  }
  begin_navigation(state.navigation);
  state.editor.hovered_peak.reset();
  state.widgets.number_taken = false;
  close_error_by_key(state, inputs, requests);
  trim_selection(state.editor, document.preset.transfer_function);
  follow_shown_values(state, document.preset.transfer_function, inputs);
  state.widgets.take_typed = inputs.close_requested || takes_typed_text();
  if (state.widgets.refused) state.widgets.refused->is_shown = false;
  const ActionContext context{document, state, inputs, requests};
  requests.document_changed |= shortcuts(context);
  requests.document_changed |= menu_bar(context);
  close_menu_by_key(state);
  requests.document_changed |= studio_window(document, state, inputs, requests);
  requests.lit_points = lit_points(state, inputs);
  requests.document_changed |= command_palette(context);
  export_dialog(document, state, inputs, requests);
  import_dialog(state, inputs, requests);
  opening_dialog(state, inputs, requests);
  picture_dialog(document, state, inputs);
  requests.document_changed |= preset_details(document, state);
  library_window(state, inputs, requests);
  if (inputs.dropped_preset) requests.open_preset = inputs.dropped_preset;
  file_question(state, requests);
  unsaved_question(document, state, inputs, requests);
  saving_question(state, inputs, requests);
  help_window(state);
  about_window(state, inputs.version);
  settings_window(state);
  end_navigation(state.navigation);
  requests.show_visibility = is_visibility(state.editor.value_curve);
  if (!ImGui::IsAnyItemActive()) state.widgets.typed.clear();
  if (state.widgets.refused && !state.widgets.refused->is_shown) state.widgets.refused.reset();
  // A number that was typed is a step of its own, also where a press elsewhere took it.
  if (state.widgets.number_taken || !is_editing(state)) state.history.record(document);
  return requests;
}

}  // namespace crest
