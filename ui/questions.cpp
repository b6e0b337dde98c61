#include "ui/questions.h"

#include <utility>

#include "ui/comparison_view.h"
#include "ui/history_panel.h"
#include "ui/style.h"

namespace crest {
namespace {

struct HelpLine {
  const char* keys;
  const char* meaning;
};

constexpr HelpLine help_lines[] = {
    {"", "Transfer function"},
    {"double-click", "add a point; on a point: its colour; on the axis: show all values"},
    {"P, S", "add a spike, a step; then type its value"},
    {"drag",
     "move the selected points; Shift keeps the axis, Alt does not snap; on empty ground: select a box"},
    {"bar over the plot", "drag: shift the selected points, or all; its ends stretch them"},
    {"Ctrl+C, Ctrl+X, Ctrl+V", "copy, cut and paste points"},
    {"Ctrl+click, Ctrl+A", "add to the selection, select all"},
    {"arrows", "nudge by a pixel; Shift: by 10, Alt: by a tenth; Ctrl: next point"},
    {"Delete", "remove the selected points"},
    {"right-click", "menu: add a peak, step or other shape; surface auto, on or off"},
    {"wheel", "zoom about the mouse; Ctrl: faster; Shift: pan"},
    {"middle drag", "pan; also: drag the axis"},
    {"F", "zoom to the selected points"},
    {"blue triangle", "a value where the volume is steep: click to add a spike there"},
    {"", "Views"},
    {"left drag", "turn"},
    {"middle or right drag", "move; also: Shift+left drag"},
    {"wheel", "nearer, further"},
    {"double-click", "enlarge a view, and back (Esc)"},
    {"click", "inspect the pixel's ray"},
    {"right-click", "select the peak that shows there, or make one"},
    {"1 .. 4", "enlarge this view, and back"},
    {"Ctrl+1 .. 4", "so many views"},
    {"X", "the exact picture at rest, or as the settings have it"},
    {"B", "how far each pixel of the exact picture may be off"},
    {"R", "reset: the whole volume in view"},
    {"", "Slices"},
    {"left drag, wheel", "move the cursor; the next slice"},
    {"", "Files"},
    {"Ctrl+O, Ctrl+Shift+O", "open a volume, a preset"},
    {"Ctrl+S, Ctrl+Shift+S", "save the preset, save it as"},
    {"Ctrl+L", "the library of presets, as they look on this volume"},
    {"Ctrl+P", "save a picture, or one turn"},
    {"Ctrl+E", "export the preset for another program"},
    {"Ctrl+Z, Ctrl+Shift+Z", "undo, redo (also Ctrl+Y)"},
    {"F5", "reload the shaders"},
    {"Ctrl+Q", "quit"},
};

}  // namespace

void center_next_window() {
  const ImVec2 display = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({display.x / 2, display.y / 2}, ImGuiCond_Appearing, {0.5F, 0.5F});
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
  constexpr const char* title = "Unsaved changes";
  if (!ImGui::IsPopupOpen(title)) ImGui::OpenPopup(title);
  center_next_window();
  if (!ImGui::BeginPopupModal(title, nullptr, ImGuiWindowFlags_AlwaysAutoResize)) return;
  ImGui::Text("%s has changes that are not saved:", preset_label(document).c_str());
  if (inputs.saved) change_list(state.changes, *inputs.saved, document.preset, 8);
  ImGui::Spacing();
  const ImVec2 size{scaled(104), 0};
  const auto button = [&](const char* text) {
    const bool pressed = ImGui::Button(text, size);
    note_item(state.widgets, text);
    if (pressed) ImGui::CloseCurrentPopup();
    return pressed;
  };
  if (button("Save##quit")) {
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
  if (button("Stay") || ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape), false)) {
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
  if (is_saving && !ImGui::IsPopupOpen(title)) ImGui::OpenPopup(title);
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
  const bool stays =
      ImGui::Button("Stay##saving", size) || ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape), false);
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

void help_window(StudioState& state) {
  constexpr const char* title = "Keys and mouse";
  if (state.show_help) ImGui::OpenPopup(title);
  state.show_help = false;
  center_next_window();
  bool open = true;
  if (!ImGui::BeginPopupModal(title, &open, ImGuiWindowFlags_AlwaysAutoResize)) return;
  for (const HelpLine& line : help_lines) {
    if (*line.keys == '\0') {
      ImGui::Spacing();
      ImGui::PushStyleColor(ImGuiCol_Text, palette::accent);
      ImGui::TextUnformatted(line.meaning);
      ImGui::PopStyleColor();
      continue;
    }
    ImGui::TextUnformatted(line.keys);
    ImGui::SameLine(scaled(190));
    ImGui::TextDisabled("%s", line.meaning);
  }
  ImGui::Spacing();
  if (ImGui::Button("Close", {scaled(104), 0}) ||
      ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape), false))
    ImGui::CloseCurrentPopup();
  note_item(state.widgets, "close help");
  ImGui::EndPopup();
}

}  // namespace crest
