#include "ui/import_dialog.h"

#include <fmt/core.h>

#include <algorithm>

#include "ui/navigation.h"
#include "ui/questions.h"
#include "ui/style.h"

namespace crest {
namespace {

constexpr const char* title = "Import a transfer function";

/// What has no opacities is taken for its colours, and maps over 0..1 are laid over the data, as in ParaView.
void choose(ImportDialog& dialog, std::span<const Imported> all, int index) {
  const Imported& one = all[std::size_t(index)];
  dialog.chosen = index;
  if (!one.has_opacities && dialog.take == TfParts::both) dialog.take = TfParts::colors;
  dialog.fit = is_over_unit_range(one.preset.transfer_function);
}

void list_of_presets(StudioState& state, std::span<const Imported> all) {
  ImGui::BeginChild("imported", {0, scaled(220)}, true, ImGuiWindowFlags_NavFlattened);
  for (int i = 0; i < int(all.size()); ++i) {
    const Imported& one = all[std::size_t(i)];
    if (ImGui::Selectable(fmt::format("{}##{}", one.preset.name, i).c_str(), state.import_dialog.chosen == i,
                          ImGuiSelectableFlags_DontClosePopups))
      choose(state.import_dialog, all, i);
    note_item(state.widgets, fmt::format("import/{}", i));
    ImGui::SameLine(scaled(300));
    ImGui::TextDisabled("%d points%s", int(one.preset.transfer_function.points.size()),
                        one.has_opacities ? "" : ", colours alone");
  }
  ImGui::EndChild();
}

}  // namespace

void parts_choice(WidgetState& widgets, TfParts& take) {
  const auto radio = [&](const char* text, TfParts parts) {
    if (ImGui::RadioButton(text, take == parts)) take = parts;
    note_item(widgets, text);
  };
  radio("both", TfParts::both);
  ImGui::SameLine();
  radio("colours only", TfParts::colors);
  ImGui::SameLine();
  radio("opacities only", TfParts::opacities);
}

void import_dialog(StudioState& state, const StudioInputs& inputs, StudioRequests& requests) {
  ImportDialog& dialog = state.import_dialog;
  if (!inputs.imported.empty() && !ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup)) {
    dialog = {.chosen = -1, .take = inputs.import_take, .fit = false};
    choose(dialog, inputs.imported, 0);
    open_when_free(title);
  }
  const ImVec2 display = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({display.x / 2, display.y / 2}, ImGuiCond_Appearing, {0.5F, 0.5F});
  ImGui::SetNextWindowSize({std::min(scaled(620), display.x * 0.9F), 0}, ImGuiCond_Appearing);
  if (!ImGui::BeginPopupModal(title, nullptr, ImGuiWindowFlags_NoSavedSettings)) return;
  const std::span<const Imported> all = inputs.imported;
  if (all.empty()) {
    ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
    return;
  }
  dialog.chosen = std::clamp(dialog.chosen, 0, int(all.size()) - 1);
  list_of_presets(state, all);
  parts_choice(state.widgets, dialog.take);
  checkbox(state.widgets, "##fit import", dialog.fit);
  ImGui::SameLine();
  ImGui::TextUnformatted("over the range of the present points");
  for (const std::string& note : all[std::size_t(dialog.chosen)].notes) {
    ImGui::Bullet();
    ImGui::TextWrapped("%s", note.c_str());
  }
  ImGui::Spacing();
  if (default_button("Import", {scaled(96), 0}))
    requests.import_choice = {dialog.chosen, dialog.take, dialog.fit};
  note_item(state.widgets, "take import");
  ImGui::SameLine();
  if (ImGui::Button("Cancel", {scaled(96), 0}) || escape_pressed(state.widgets))
    requests.import_choice = {-1, dialog.take, false};
  note_item(state.widgets, "cancel import");
  if (requests.import_choice) ImGui::CloseCurrentPopup();
  ImGui::EndPopup();
}

}  // namespace crest
