#include "ui/menu_bar.h"

#include <fmt/core.h>
#include <imgui_internal.h>

#include <utility>

#include "ui/style.h"

namespace crest {
namespace {

bool item(const ActionContext& context, const Action& action) {
  const bool enabled = why_not(action, context).empty();
  const bool checked = action.checked && action.checked(context);
  const std::string label = fmt::format("{}###{}", title_of(action, context), action.name);
  const bool chosen = ImGui::MenuItem(label.c_str(), key_text_of(action).c_str(), checked, enabled);
  note_item(context.state.widgets, action.name);
  if (!action.tip.empty()) tip(action.tip.c_str());
  return chosen && action.run(context);
}

bool begin_menu(StudioState& state, const std::string& name) {
  const bool open = ImGui::BeginMenu(name.c_str());
  note_item(state.widgets, fmt::format("menu/{}", name));
  return open;
}

bool submenu(const ActionContext& context, const Action& list) {
  const std::vector<Action> entries = list.entries(context);
  if ((entries.empty() && list.if_none.empty()) || !begin_menu(context.state, list.name)) return false;
  bool changed = false;
  for (const Action& entry : entries) changed |= item(context, entry);
  if (entries.empty()) ImGui::TextDisabled("%s", list.if_none.c_str());
  ImGui::EndMenu();
  return changed;
}

bool menu(const ActionContext& context, Section section) {
  if (!begin_menu(context.state, std::string(title_of(section)))) return false;
  bool changed = false;
  for (const Action& action : actions()) {
    if (action.section != section) continue;
    if (action.separated) ImGui::Separator();
    changed |= action.entries ? submenu(context, action) : item(context, action);
  }
  ImGui::EndMenu();
  return changed;
}

/// As a click on it would, with the focus shown in it.
void open_first_menu() {
  ImGui::OpenPopup(std::string(title_of(Section(0))).c_str());
  ImGui::GetCurrentContext()->NavDisableHighlight = false;
}

/// The preset's name at the right end, with a dot before it while it has changes that are not saved. A click
/// edits it.
void preset_name(const Document& document, StudioState& state, const StudioInputs& inputs) {
  const std::string& name = document.preset.name;
  const std::string file = document.preset_path.filename().string();
  const std::string text = !name.empty() ? name : !file.empty() ? file : "new preset";
  const float width = ImGui::CalcTextSize(text.c_str()).x + scaled(28);
  const float x = ImGui::GetWindowWidth() - width;
  if (x < ImGui::GetCursorPosX()) return;
  ImGui::SetCursorPosX(x);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  if (inputs.unsaved_changes)
    ImGui::GetWindowDrawList()->AddCircleFilled({at.x, at.y + ImGui::GetFrameHeight() / 2}, scaled(4),
                                                palette().accent);
  ImGui::SetCursorPosX(x + scaled(10));
  ImGui::TextDisabled("%s", text.c_str());
  note_item(state.widgets, "preset title");
  if (ImGui::IsItemClicked()) state.details.asked = true;
  const std::string& notes = document.preset.notes;
  tip(fmt::format("{}{}{}Click for its name, notes and tags", inputs.unsaved_changes ? "Not saved yet\n" : "",
                  notes, notes.empty() ? "" : "\n")
          .c_str());
}

}  // namespace

bool menu_bar(const ActionContext& context) {
  if (!ImGui::BeginMainMenuBar()) return false;
  if (std::exchange(context.state.navigation.asked_menu, false)) open_first_menu();
  bool changed = false;
  for (int i = 0; i < menu_count; ++i) changed |= menu(context, Section(i));
  preset_name(context.document, context.state, context.inputs);
  ImGui::EndMainMenuBar();
  return changed;
}

}  // namespace crest
