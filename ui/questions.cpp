#include "ui/questions.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "ui/comparison_view.h"
#include "ui/history_panel.h"
#include "ui/style.h"

namespace crest {
void center_next_window() {
  const ImVec2 display = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({display.x / 2, display.y / 2}, ImGuiCond_Appearing, {0.5F, 0.5F});
}

void open_when_free(const char* title) {
  if (!ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup)) ImGui::OpenPopup(title);
}

void ask_for_file(StudioState& state, const Document& document, FilePurpose purpose) {
  const std::string source = document.volume_source.substr(0, document.volume_source.find('?'));
  const bool is_file = !source.empty() && !source.starts_with("builtin:");
  const std::filesystem::path volume = is_file ? source : "";
  open_file_dialog(
      state.file_dialog, purpose,
      purpose == FilePurpose::open_volume || document.preset_path.empty() ? volume : document.preset_path);
  if (purpose == FilePurpose::save_preset && document.preset_path.empty())
    state.file_dialog.name = (document.library_name.empty() ? "preset" : document.library_name) + ".json";
}

namespace {

constexpr const char* unsaved_title = "Unsaved changes";

/// What would lose changes goes from the requests into `leaving`.
void hold_back(StudioState& state, StudioRequests& requests) {
  Leaving asked;
  asked.quit = std::exchange(state.quit_asked, false);
  asked.new_preset = std::exchange(requests.new_preset, false);
  // Its colours or its opacities alone are an edit, which can be undone
  if (requests.take == TfParts::both) asked.open_preset = std::exchange(requests.open_preset, std::nullopt);
  if (asked.open_preset) asked.open_volume = std::exchange(requests.open_volume, std::nullopt);
  if (asked.is_any()) state.leaving = asked;
}

void let_go(StudioState& state, StudioRequests& requests) {
  const Leaving leaving = std::exchange(state.leaving, {});
  requests.quit = leaving.quit;
  requests.new_preset = leaving.new_preset;
  if (leaving.open_preset) requests.open_preset = leaving.open_preset;
  if (leaving.open_volume) requests.open_volume = leaving.open_volume;
}

}  // namespace

void unsaved_question(Document& document, StudioState& state, const StudioInputs& inputs,
                      StudioRequests& requests) {
  if (inputs.close_requested) state.quit_asked = true;
  hold_back(state, requests);
  if (!state.leaving.is_any() || state.leaving.once_saved) return;
  if (state.widgets.number_taken) return;  // whether what was typed last is saved is known in the next frame
  if (!inputs.unsaved_changes) return let_go(state, requests);
  if (!ImGui::IsPopupOpen(unsaved_title)) ImGui::OpenPopup(unsaved_title);
  center_next_window();
  if (!ImGui::BeginPopupModal(unsaved_title, nullptr, ImGuiWindowFlags_AlwaysAutoResize)) return;
  ImGui::Text("%s has changes that are not saved:", preset_label(document).c_str());
  if (inputs.saved) change_list(state.changes, *inputs.saved, document.preset, 8);
  ImGui::Spacing();
  const ImVec2 size{scaled(104), 0};
  const auto button = [&](const char* text, bool is_default = false) {
    const bool pressed = is_default ? default_button(text, size) : ImGui::Button(text, size);
    note_item(state.widgets, text);
    if (pressed) ImGui::CloseCurrentPopup();
    return pressed;
  };
  if (button("Save##quit", true)) {
    if (document.preset_path.empty()) {
      state.leaving.once_saved = true;
      ask_for_file(state, document, FilePurpose::save_preset);
    } else {
      requests.save_preset = document.preset_path;
      let_go(state, requests);
    }
  }
  ImGui::SameLine();
  if (button("Discard")) let_go(state, requests);
  ImGui::SameLine();
  if (button("Stay") || escape_pressed(state.widgets)) {
    state.leaving = {};
    ImGui::CloseCurrentPopup();
  }
  ImGui::EndPopup();
}

void saving_question(StudioState& state, const StudioInputs& inputs, StudioRequests& requests) {
  const bool is_saving = !inputs.saving.empty();
  if (requests.quit && is_saving) {
    requests.quit = false;
    state.quits_when_saved = true;
  }
  if (!state.quits_when_saved) return;
  constexpr const char* title = "A picture is being saved";
  // Of two questions the one about what would be lost comes first
  if (is_saving && !ImGui::IsPopupOpen(title) && !ImGui::IsPopupOpen(unsaved_title)) ImGui::OpenPopup(title);
  center_next_window();
  if (!ImGui::BeginPopupModal(title, nullptr, ImGuiWindowFlags_AlwaysAutoResize)) return;
  requests.animates = true;  // how far it is
  ImGui::TextUnformatted(inputs.saving.c_str());
  ImGui::TextUnformatted("Crest quits when it is done.");
  ImGui::Spacing();
  const ImVec2 size{scaled(104), 0};
  const bool quits = ImGui::Button("Quit anyway", size);
  note_item(state.widgets, "Quit anyway");
  tip("The picture that is being drawn is lost; those of a turn that are done stay");
  ImGui::SameLine();
  const bool stays = ImGui::Button("Stay##saving", size) || escape_pressed(state.widgets);
  note_item(state.widgets, "stay for saving");
  if (quits && is_saving) requests.quit = true;
  // What failed is told, and what was edited meanwhile is asked about
  if (!is_saving && !inputs.message_is_error) state.quit_asked = true;
  if (quits || stays || !is_saving) {
    state.quits_when_saved = false;
    ImGui::CloseCurrentPopup();
  }
  ImGui::EndPopup();
}

void file_question(StudioState& state, StudioRequests& requests) {
  const FilePurpose purpose = state.file_dialog.purpose;
  if (const auto path = file_dialog(state.file_dialog, state.widgets)) {
    if (purpose == FilePurpose::open_volume) requests.open_volume = *path;
    if (purpose == FilePurpose::open_preset) {
      requests.open_preset = *path;
      requests.take = state.file_dialog.take;
    }
    if (purpose == FilePurpose::view_preset) take_other_preset(state.views, *path);
    if (purpose == FilePurpose::export_preset) requests.export_preset = {state.export_dialog.to_write, *path};
    if (purpose == FilePurpose::save_preset) requests.save_preset = *path;
    if (purpose == FilePurpose::save_ray) requests.save_ray = *path;
    if (purpose == FilePurpose::save_picture) {
      requests.save_picture = state.picture_dialog.ask;
      requests.save_picture->path = *path;
    }
  }
  if (!state.leaving.once_saved) return;
  if (requests.save_preset)
    let_go(state, requests);
  else if (!state.file_dialog.open)
    state.leaving = {};  // no name was given
}

}  // namespace crest
