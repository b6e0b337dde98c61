#include "ui/actions.h"

#include <fmt/core.h>
#include <imgui_internal.h>

#include <algorithm>
#include <cctype>
#include <stdexcept>

#include "ui/studio_state.h"

namespace crest {

std::string_view title_of(Section section) {
  constexpr std::string_view titles[section_count] = {
      "Volume", "Preset", "Edit", "View", "Help", "Transfer function", "Compare", "Panels"};
  return titles[std::size_t(section)];
}

std::span<const Action> actions() {
  static const std::vector<Action> table = [] {
    std::vector<Action> all;
    add_file_actions(all);
    add_edit_actions(all);
    add_view_actions(all);
    add_compare_actions(all);
    add_window_actions(all);
    return all;
  }();
  return table;
}

const Action& action_named(std::string_view name) {
  const auto found = std::ranges::find(actions(), name, &Action::name);
  if (found == actions().end()) throw std::out_of_range(fmt::format("there is no action {}", name));
  return *found;
}

std::string key_text_of(const Action& action) { return text_of(action.key); }
std::string key_text_of(std::string_view name) { return key_text_of(action_named(name)); }

std::string why_not(const Action& action, const ActionContext& context) {
  return action.why_not ? action.why_not(context) : std::string();
}

std::string needs_volume(const ActionContext& context) {
  return context.inputs.volume ? "" : "no volume is open";
}

std::string title_of(const Action& action, const ActionContext& context) {
  const std::string detail = action.detail ? action.detail(context) : std::string();
  return detail.empty() ? action.name : fmt::format("{}: {}", action.name, detail);
}

namespace {

/// Whether a field is open in which nothing was typed yet.
bool only_opened(const WidgetState& widgets) {
  return ImGui::GetIO().WantTextInput && std::ranges::all_of(widgets.typed, [](const auto& typed) {
           return typed.second.text == typed.second.shown;
         });
}

/// Or what is typed now is meant for a field that is not open yet. Dear ImGui wants text for a frame more
/// after a field was closed, and keys that follow Enter at once must count.
bool is_typing(const WidgetState& widgets) {
  return (ImGui::GetIO().WantTextInput && ImGui::IsAnyItemActive()) || widgets.ahead.field != 0;
}

bool counts(KeyWhen when, const WidgetState& widgets) {
  switch (when) {
    case KeyWhen::always:
      return true;
    case KeyWhen::not_typing:
      return !is_typing(widgets);
    case KeyWhen::untouched:
      // A field that is being typed in has an undo of its own, and a drag is one step that is not over
      return !ImGui::IsAnyItemActive() || only_opened(widgets);
    case KeyWhen::at_rest:
      break;
  }
  return !is_typing(widgets) && !ImGui::IsAnyItemActive() && !ImGui::IsAnyMouseDown();
}

bool has_key_pressed(const Action& action) { return is_pressed(action.key) || is_pressed(action.other_key); }

/// A letter that was a command is none for the field that it opens.
void drop_typed(int letter) {
  ImVector<ImWchar>& typed = ImGui::GetIO().InputQueueCharacters;
  ImWchar* const found = std::find_if(typed.begin(), typed.end(),
                                      [&](ImWchar c) { return c < 128 && std::toupper(c) == letter; });
  if (found != typed.end()) typed.erase(found);
}

}  // namespace

bool shortcuts(const ActionContext& context) {
  // Esc closed one before the frame began
  if (ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup) || context.state.navigation.popups > 0) return false;
  bool changed = false;
  for (const Action& action : actions()) {
    if (!has_key_pressed(action) || !counts(action.when, context.state.widgets)) continue;
    if (!why_not(action, context).empty()) continue;
    if (action.when == KeyWhen::untouched) ImGui::ClearActiveID();
    drop_typed(action.key.key);
    changed |= action.run(context);
  }
  return changed;
}

bool takes_typed_text() {
  return std::ranges::any_of(actions(), [](const Action& a) { return a.takes_typed && has_key_pressed(a); });
}

}  // namespace crest
