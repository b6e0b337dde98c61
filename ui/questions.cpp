#include "ui/questions.h"

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
    {"drag", "move the selected points; Shift keeps the axis; on empty ground: select a box"},
    {"Ctrl+click, Ctrl+A", "add to the selection, select all"},
    {"arrows", "nudge by a pixel; Shift: by 10, Alt: by a tenth; Ctrl: next point"},
    {"Delete", "remove the selected points"},
    {"right-click", "menu: add a peak or step, surface auto, on or off"},
    {"wheel", "zoom about the mouse; Ctrl: faster; Shift: pan"},
    {"middle drag", "pan; also: drag the axis"},
    {"F", "zoom to the selected points"},
    {"blue triangle", "a value where the volume is steep: click to add a spike there"},
    {"", "Views"},
    {"left drag", "turn"},
    {"middle or right drag", "move; also: Shift+left drag"},
    {"wheel", "nearer, further"},
    {"double-click", "enlarge a view, and back (Esc)"},
    {"X", "the exact picture at rest, or as the settings have it"},
    {"B", "how far each pixel of the exact picture may be off"},
    {"R", "reset: the whole volume in view"},
    {"", "Slices"},
    {"left drag, wheel", "move the cursor; the next slice"},
    {"", "Files"},
    {"Ctrl+O, Ctrl+Shift+O", "open a volume, a preset"},
    {"Ctrl+S, Ctrl+Shift+S", "save the preset, save it as"},
    {"Ctrl+E", "export the preset for another program"},
    {"Ctrl+Z, Ctrl+Shift+Z", "undo, redo (also Ctrl+Y)"},
    {"F5", "reload the shaders"},
    {"Ctrl+Q", "quit"},
};

void center_next_window() {
  const ImVec2 display = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({display.x / 2, display.y / 2}, ImGuiCond_Appearing, {0.5F, 0.5F});
}

}  // namespace

void ask_for_file(StudioState& state, const Document& document, FilePurpose purpose) {
  const std::string source = document.volume_source.substr(0, document.volume_source.find('?'));
  const bool is_file = !source.empty() && !source.starts_with("builtin:");
  const std::filesystem::path volume = is_file ? source : "";
  open_file_dialog(
      state.file_dialog, purpose,
      purpose == FilePurpose::open_volume || document.preset_path.empty() ? volume : document.preset_path);
  if (purpose == FilePurpose::save_preset && document.preset_path.empty())
    state.file_dialog.name = "preset.json";
}

void quit_question(Document& document, StudioState& state, const StudioInputs& inputs,
                   StudioRequests& requests) {
  if (inputs.close_requested) state.quit_asked = true;
  constexpr const char* title = "Unsaved changes";
  if (state.quit_asked && !ImGui::IsPopupOpen(title)) {
    if (!inputs.unsaved_changes) {
      requests.quit = true;
      state.quit_asked = false;
      return;
    }
    ImGui::OpenPopup(title);
  }
  center_next_window();
  if (!ImGui::BeginPopupModal(title, nullptr, ImGuiWindowFlags_AlwaysAutoResize)) return;
  ImGui::TextUnformatted("The preset has changes that are not saved.");
  ImGui::Spacing();
  const ImVec2 size{scaled(104), 0};
  const auto button = [&](const char* text) {
    const bool pressed = ImGui::Button(text, size);
    note_item(state.widgets, text);
    if (pressed) {
      state.quit_asked = false;
      ImGui::CloseCurrentPopup();
    }
    return pressed;
  };
  if (button("Save##quit")) {
    state.quit_after_save = true;
    if (document.preset_path.empty())
      ask_for_file(state, document, FilePurpose::save_preset);
    else
      requests.save_preset = document.preset_path;
  }
  ImGui::SameLine();
  if (button("Discard")) requests.quit = true;
  ImGui::SameLine();
  button("Stay");
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
    if (purpose == FilePurpose::export_preset) requests.export_preset = {state.export_dialog.to_write, *path};
    if (purpose == FilePurpose::save_preset) requests.save_preset = *path;
  }
  if (state.quit_after_save && requests.save_preset) requests.quit = true;
  if (!state.file_dialog.open) state.quit_after_save = false;
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
