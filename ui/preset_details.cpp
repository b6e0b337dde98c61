#include "ui/preset_details.h"

#include <imgui_stdlib.h>

#include <algorithm>

#include "ui/questions.h"
#include "ui/style.h"

namespace crest {
namespace {

constexpr float field_width = 420;

}  // namespace

std::string tags_text(const std::vector<std::string>& tags) {
  std::string text;
  for (const std::string& tag : tags) text += (text.empty() ? "" : ", ") + tag;
  return text;
}

std::vector<std::string> tags_in(std::string_view text) {
  std::vector<std::string> tags;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    std::string_view tag = text.substr(begin, end - begin);
    while (tag.starts_with(' ')) tag.remove_prefix(1);
    while (tag.ends_with(' ')) tag.remove_suffix(1);
    if (!tag.empty() && std::ranges::find(tags, tag) == tags.end()) tags.emplace_back(tag);
    begin = end + 1;
  }
  return tags;
}

bool preset_details(Document& document, StudioState& state) {
  constexpr const char* title = "Name and notes";
  PresetDetails& details = state.details;
  Preset& preset = document.preset;
  if (std::exchange(details.asked, false)) {
    ImGui::OpenPopup(title);
    details.tags = tags_text(preset.tags);
  }
  center_next_window();
  bool open = true, changed = false;
  // Each field is a step of its own, also where the next one is entered at once
  const auto end_field = [&](const char* name) {
    note_item(state.widgets, name);
    if (ImGui::IsItemDeactivatedAfterEdit()) state.history.record(document);
  };
  if (!ImGui::BeginPopupModal(title, &open, ImGuiWindowFlags_AlwaysAutoResize)) return false;
  const float width = scaled(field_width);
  ImGui::TextDisabled("Name");
  if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
  ImGui::SetNextItemWidth(width);
  const bool entered = ImGui::InputText("##preset name", &preset.name, ImGuiInputTextFlags_EnterReturnsTrue);
  changed |= ImGui::IsItemEdited();
  end_field("preset name");
  ImGui::TextDisabled("Notes");
  changed |= ImGui::InputTextMultiline("##preset notes", &preset.notes, {width, scaled(120)});
  end_field("preset notes");
  ImGui::TextDisabled("Tags, with commas between them");
  ImGui::SetNextItemWidth(width);
  if (ImGui::InputText("##preset tags", &details.tags)) {
    preset.tags = tags_in(details.tags);
    changed = true;
  }
  end_field("preset tags");
  ImGui::Spacing();
  const bool is_done = default_button("Done", {scaled(104), 0});
  note_item(state.widgets, "details done");
  ImGui::SameLine();
  ImGui::TextDisabled("Save keeps them in the preset's file");
  const bool is_escaped = escape_pressed(state.widgets);
  if (entered || is_done || is_escaped) ImGui::CloseCurrentPopup();
  ImGui::EndPopup();
  return changed;
}

}  // namespace crest
