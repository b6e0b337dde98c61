#include "ui/picture_dialog.h"

#include <fmt/core.h>

#include <algorithm>

#include "ui/number_field.h"
#include "ui/questions.h"

namespace crest {
namespace {

constexpr const char* title = "Save a picture";
constexpr int longest_side = 16384;

void size_row(WidgetState& widgets, PictureDialog& dialog) {
  field_label("Size");
  integer_field(widgets, "##picture width", dialog.ask.size.x, 1, longest_side, scaled(70));
  ImGui::SameLine(0, scaled(4));
  ImGui::TextDisabled("x");
  ImGui::SameLine(0, scaled(4));
  integer_field(widgets, "##picture height", dialog.ask.size.y, 1, longest_side, scaled(70));
  const auto preset = [&](const char* text, glm::ivec2 size) {
    ImGui::SameLine(0, scaled(6));
    if (ImGui::Button(text)) dialog.ask.size = size;
    note_item(widgets, fmt::format("size/{}", text));
  };
  const bool is_editor = dialog.ask.view == picture_of_editor;
  preset("as shown", is_editor ? dialog.editor_as_shown : dialog.as_shown);
  preset("1920 x 1080", {1920, 1080});
  preset("3840 x 2160", {3840, 2160});
}

/// A picture of the editor has another form than one of a view: with it goes the size that is shown.
void choose(PictureDialog& dialog, int view) {
  const bool was_editor = dialog.ask.view == picture_of_editor, is_editor = view == picture_of_editor;
  dialog.ask.view = view;
  if (is_editor != was_editor || dialog.ask.size.x <= 0)
    dialog.ask.size = is_editor ? dialog.editor_as_shown : dialog.as_shown;
}

void what_row(StudioState& state, PictureDialog& dialog, bool has_volume) {
  field_label("Of");
  const auto button = [&](const std::string& text, int view, const std::string& name) {
    if (ImGui::RadioButton(text.c_str(), dialog.ask.view == view)) choose(dialog, view);
    note_item(state.widgets, "picture of/" + name);
  };
  if (has_volume) {
    button("the views, side by side", picture_of_grid, "views");
    for (int i = 0; i < view_count; ++i)
      button(fmt::format("view {}: {}", i + 1, text_of(state.views.contents[std::size_t(i)])), i,
             fmt::format("{}", i));
  }
  button("the transfer function, as the editor shows it", picture_of_editor, "editor");
}

void turn_row(StudioState& state, PictureDialog& dialog) {
  if (dialog.ask.view == picture_of_editor) return;
  field_label("Pictures of one turn");
  integer_field(state.widgets, "##turntable", dialog.ask.turntable, 1, 3600, scaled(60));
  tip("1 is a single picture; 36 are ten degrees apart, in numbered files");
  ImGui::Spacing();
}

}  // namespace

void picture_dialog(Document& document, StudioState& state, const StudioInputs& inputs) {
  PictureDialog& dialog = state.picture_dialog;
  if (std::exchange(dialog.asked, false)) {
    ImGui::OpenPopup(title);
    choose(dialog, !inputs.volume              ? picture_of_editor
                   : state.views.enlarged >= 0 ? state.views.enlarged
                                               : dialog.ask.view);
  }
  center_next_window();
  bool open = true;
  if (!ImGui::BeginPopupModal(title, &open, ImGuiWindowFlags_AlwaysAutoResize)) return;
  what_row(state, dialog, inputs.volume != nullptr);
  ImGui::Spacing();
  size_row(state.widgets, dialog);
  ImGui::Spacing();
  turn_row(state, dialog);
  ImGui::TextDisabled(".png or .exr. The file keeps the preset: dropped on the window, it opens it.");
  ImGui::Spacing();
  if (default_button("File ...", {scaled(104), 0})) {
    ImGui::CloseCurrentPopup();
    ask_for_file(state, document, FilePurpose::save_picture);
  }
  note_item(state.widgets, "picture file");
  ImGui::SameLine();
  if (ImGui::Button("Cancel", {scaled(104), 0}) || escape_pressed(state.widgets)) ImGui::CloseCurrentPopup();
  ImGui::EndPopup();
}

}  // namespace crest
