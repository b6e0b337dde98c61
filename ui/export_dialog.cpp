#include "ui/export_dialog.h"

#include <fmt/core.h>

#include <algorithm>
#include <tuple>

#include "presets/error.h"
#include "presets/exchange/table.h"
#include "render/scene/export_input.h"
#include "ui/number_field.h"
#include "ui/questions.h"
#include "ui/style.h"

namespace crest {
namespace {

constexpr const char* title = "Export the preset";

int rows_of(const ExportDialog& dialog) { return dialog.automatic_rows ? 0 : dialog.rows; }

std::string stem_of(const Document& document) {
  const std::string stem = document.preset_path.stem().string();
  return stem.empty() ? "preset" : stem;
}

/// What is lost and what to do, once for each preset, format and size.
void update_sentences(const Document& document, const StudioInputs& inputs, ExportDialog& dialog) {
  const int rows = rows_of(dialog);
  const ExportDialog::Shown& s = dialog.shown;
  if (std::tie(s.format, s.rows, s.volume, s.volume_source, s.preset_path, s.preset) ==
      std::tie(dialog.format, rows, inputs.volume, document.volume_source, document.preset_path,
               document.preset))
    return;
  dialog.shown = {dialog.format,        rows,           inputs.volume, document.volume_source,
                  document.preset_path, document.preset};
  dialog.losses.clear();
  dialog.advice.clear();
  dialog.error.clear();
  try {
    const Exported exported = exporters()[std::size_t(dialog.format)].write(
        export_input(document.preset, inputs.volume, rows, stem_of(document)));
    dialog.losses = exported.losses;
    dialog.advice = exported.advice;
  } catch (const Error& error) {
    dialog.error = error.what();
  }
}

void sentences(const char* heading, const std::vector<std::string>& list, ImU32 color) {
  if (list.empty()) return;
  ImGui::PushStyleColor(ImGuiCol_Text, color);
  ImGui::TextUnformatted(heading);
  ImGui::PopStyleColor();
  for (const std::string& sentence : list) {
    ImGui::Bullet();
    ImGui::TextWrapped("%s", sentence.c_str());
  }
  ImGui::Spacing();
}

void list_of_formats(StudioState& state, float height) {
  ExportDialog& dialog = state.export_dialog;
  ImGui::BeginChild("formats", {scaled(190), height}, true, ImGuiWindowFlags_NavFlattened);
  for (int i = 0; i < int(exporters().size()); ++i) {
    const Exporter& exporter = exporters()[std::size_t(i)];
    if (ImGui::Selectable(std::string(exporter.title).c_str(), dialog.format == i,
                          ImGuiSelectableFlags_DontClosePopups))
      dialog.format = i;
    note_item(state.widgets, fmt::format("export/{}", exporter.name));
  }
  ImGui::EndChild();
}

void table_size(StudioState& state) {
  ExportDialog& dialog = state.export_dialog;
  checkbox(state.widgets, "##automatic rows", dialog.automatic_rows);
  ImGui::SameLine();
  ImGui::TextUnformatted("as few rows as hold all points");
  if (dialog.automatic_rows) return;
  ImGui::SameLine();
  integer_field(state.widgets, "##rows", dialog.rows, 2, most_table_rows, scaled(80));
}

void preview(StudioState& state, const StudioInputs& inputs, StudioRequests& requests) {
  ExportDialog& dialog = state.export_dialog;
  checkbox(state.widgets, "##export preview", dialog.preview);
  ImGui::SameLine();
  ImGui::TextUnformatted("the view as the target will draw it");
  if (!dialog.preview || !inputs.volume || !dialog.error.empty()) return;
  requests.preview_export = {dialog.format, rows_of(dialog)};
  const ExportPicture& picture = inputs.export_picture;
  if (picture.texture == 0) return;
  const float width = std::min(ImGui::GetContentRegionAvail().x, scaled(964));
  ImGui::Image(ImTextureID(picture.texture), {width, width * float(picture.size.y) / float(picture.size.x)});
  note_item(state.widgets, "export picture");
  ImGui::TextDisabled("RMSE %.3g, largest difference %.3g, %.3g %% of the pixels off by more than 1/255",
                      picture.rmse, picture.max, 100 * picture.share);
}

void buttons(const Document& document, StudioState& state) {
  ExportDialog& dialog = state.export_dialog;
  const Exporter& exporter = exporters()[std::size_t(dialog.format)];
  const bool can_write = dialog.error.empty();
  if (default_button("Choose the file...", {scaled(150), 0}) && can_write) {
    dialog.to_write = {dialog.format, rows_of(dialog)};
    ask_for_file(state, document, FilePurpose::export_preset);
    state.file_dialog.name = stem_of(document) + std::string(exporter.extension);
    state.file_dialog.extension = exporter.extension;
    ImGui::CloseCurrentPopup();
  }
  note_item(state.widgets, "export to file");
  ImGui::SameLine();
  if (ImGui::Button("Close", {scaled(96), 0})) ImGui::CloseCurrentPopup();
  note_item(state.widgets, "close export");
}

}  // namespace

void export_dialog(const Document& document, StudioState& state, const StudioInputs& inputs,
                   StudioRequests& requests) {
  ExportDialog& dialog = state.export_dialog;
  if (dialog.asked) ImGui::OpenPopup(title);
  dialog.asked = false;
  const ImVec2 display = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({display.x / 2, display.y / 2}, ImGuiCond_Appearing, {0.5F, 0.5F});
  // Not by what is in it: that would take frames which nobody asks for when the preview comes
  ImGui::SetNextWindowSize({std::min(scaled(1000), display.x * 0.95F), scaled(dialog.preview ? 756 : 416)});
  bool open = true;
  if (!ImGui::BeginPopupModal(title, &open, ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoResize))
    return;
  update_sentences(document, inputs, dialog);
  list_of_formats(state, scaled(300));
  ImGui::SameLine();
  ImGui::BeginChild("words", {0, scaled(300)}, true, ImGuiWindowFlags_NavFlattened);
  const Exporter& exporter = exporters()[std::size_t(dialog.format)];
  ImGui::TextUnformatted(
      fmt::format("{}, {}: {}", exporter.name, exporter.extension, exporter.summary).c_str());
  ImGui::Spacing();
  if (exporter.is_table) table_size(state);
  if (!dialog.error.empty())
    ImGui::TextColored(ImGui::ColorConvertU32ToFloat4(palette().error), "%s", dialog.error.c_str());
  sentences("Lost", dialog.losses, palette().accent);
  sentences("There", dialog.advice, palette().secondary);
  ImGui::EndChild();
  preview(state, inputs, requests);
  buttons(document, state);
  if (escape_pressed(state.widgets)) ImGui::CloseCurrentPopup();
  ImGui::EndPopup();
}

}  // namespace crest
