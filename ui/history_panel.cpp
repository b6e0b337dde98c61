#include "ui/history_panel.h"

#include <fmt/core.h>

#include <algorithm>

#include "ui/document_changes.h"
#include "ui/style.h"
#include "ui/widgets.h"

namespace crest {
namespace {

void what_is_not_saved(const Document& document, StudioState& state, const StudioInputs& inputs) {
  heading("Changed since it was saved");
  if (!inputs.unsaved_changes)
    ImGui::TextDisabled("Nothing: it is as in %s", preset_label(document).c_str());
  else if (!inputs.saved)
    ImGui::TextDisabled("All of it: it stands in no file yet");
  else
    change_list(state.changes, *inputs.saved, document.preset, 6);
}

}  // namespace

void change_list(ChangeList& list, const Preset& saved, const Preset& now, std::size_t most) {
  if (list.sentences.empty() || list.saved != saved || list.now != now) {
    list = {saved, now, changes_since(saved, now)};
    if (list.sentences.empty()) list.sentences.emplace_back("Keys of the file that Crest does not know");
  }
  const std::vector<std::string>& changes = list.sentences;
  const std::size_t shown = changes.size() > most ? most - 1 : changes.size();
  for (std::size_t i = 0; i < shown; ++i) ImGui::BulletText("%s", changes[i].c_str());
  if (shown < changes.size()) ImGui::TextDisabled("and %zu more", changes.size() - shown);
}

bool history_panel(Document& document, StudioState& state, const StudioInputs& inputs) {
  what_is_not_saved(document, state, inputs);
  ImGui::Spacing();
  heading("Steps");
  ImGui::SameLine();
  ImGui::TextDisabled("click one to go there");
  History& history = state.history;
  std::optional<std::size_t> chosen;
  ImGui::BeginChild("steps", {0, 0}, false, ImGuiWindowFlags_NavFlattened);
  for (std::size_t i = 0; i < history.steps().size(); ++i) {
    const bool is_present = i == history.present(), is_undone = i > history.present();
    const std::string label = fmt::format("{}##{}", history.steps()[i].name, i);
    if (is_undone) ImGui::PushStyleColor(ImGuiCol_Text, palette().secondary);
    if (ImGui::Selectable(label.c_str(), is_present)) chosen = i;
    if (is_undone) ImGui::PopStyleColor();
    note_item(state.widgets, fmt::format("history/{}", i));
    if (is_present && state.shown_step != i) ImGui::SetScrollHereY();
  }
  state.shown_step = history.present();
  ImGui::EndChild();
  if (!chosen) return false;
  history.record(document);
  return history.go_to(*chosen, document);
}

}  // namespace crest
