#include "ui/library_window.h"

#include <fmt/core.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <set>

#include "ui/card.h"
#include "ui/navigation.h"
#include "ui/preset_details.h"
#include "ui/questions.h"
#include "ui/style.h"

namespace crest {
namespace {

bool named_button(WidgetState& widgets, const char* text, const char* meaning = nullptr) {
  const bool pressed = ImGui::Button(text);
  note_item(widgets, fmt::format("library/{}", text));
  if (meaning) tip(meaning);
  ImGui::SameLine();
  return pressed;
}

/// The field for words, and a button for each tag that there is, in as many rows as they take.
void search_row(StudioState& state, std::span<const LibraryEntry> entries) {
  LibraryState& library = state.library;
  if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
  ImGui::SetNextItemWidth(scaled(240));
  ImGui::InputTextWithHint("##library search", "Search", &library.search);
  note_item(state.widgets, "library search");
  std::set<std::string> tags;
  for (const LibraryEntry& entry : entries) tags.insert(entry.tags.begin(), entry.tags.end());
  for (const std::string& tag : tags) {
    const bool is_on = library.tag == tag;
    const float width = ImGui::CalcTextSize(tag.c_str()).x + scaled(16);
    ImGui::SameLine();
    if (ImGui::GetContentRegionAvail().x < width) ImGui::NewLine();
    if (ImGui::Selectable(tag.c_str(), is_on, ImGuiSelectableFlags_DontClosePopups, {width - scaled(8), 0}))
      library.tag = is_on ? "" : tag;
    note_item(state.widgets, "library tag/" + tag);
  }
}

bool is_wanted(const LibraryEntry& entry, const LibraryState& library) {
  const bool has_tag = library.tag.empty() || std::ranges::find(entry.tags, library.tag) != entry.tags.end();
  return has_tag && matches(entry, library.search);
}

void open(const LibraryEntry& entry, TfParts take, StudioRequests& requests) {
  requests.open_preset = entry.name;
  requests.take = take;
  ImGui::CloseCurrentPopup();
}

/// The cards of those that are wanted; returns the one that is chosen, or null.
const LibraryEntry* cards(StudioState& state, std::span<const LibraryEntry> entries,
                          StudioRequests& requests) {
  LibraryState& library = state.library;
  const LibraryEntry* chosen = nullptr;
  const int columns = column_count();
  int shown = 0;
  for (const LibraryEntry& entry : entries) {
    if (!is_wanted(entry, library)) continue;
    place_card(shown++, columns);
    const std::string kind = entry.is_own() ? "your own" : "comes with Crest";
    const std::string tags = tags_text(entry.tags);
    const Card what{"library/" + entry.name, entry.picture, entry.title,
                    tags.empty() ? kind : kind + "; " + tags, entry.notes};
    const bool is_pressed = card(state.widgets, what);
    if (is_pressed) library.chosen = entry.name;
    const bool is_opened = (is_pressed && key_pressed(key::enter)) ||
                           (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left));
    if (library.chosen == entry.name) {
      chosen = &entry;
      ImGui::GetWindowDrawList()->AddRect(ImGui::GetItemRectMin(), ImGui::GetItemRectMax(), palette().accent,
                                          scaled(4), 0, scaled(2));
    }
    if (is_opened) library.open_chosen = true;
  }
  if (shown == 0) ImGui::TextDisabled("No preset has these words");
  if (chosen && std::exchange(library.open_chosen, false)) requests.open_preset = chosen->name;
  return chosen;
}

/// The field for a new name in place of the buttons.
void rename_row(StudioState& state, const LibraryEntry& entry, StudioRequests& requests) {
  std::string& title = *state.library.renamed;
  ImGui::SetNextItemWidth(scaled(240));
  const bool entered = ImGui::InputText("##library name", &title, ImGuiInputTextFlags_EnterReturnsTrue);
  note_item(state.widgets, "library name");
  ImGui::SameLine();
  if ((named_button(state.widgets, "Take the name") || entered) && !title.empty()) {
    requests.library = {LibraryChange::rename, entry.path, title};
    state.library.renamed.reset();
  } else if (named_button(state.widgets, "Keep the old one")) {
    state.library.renamed.reset();
  }
}

void chosen_row(StudioState& state, const LibraryEntry& entry, StudioRequests& requests) {
  WidgetState& widgets = state.widgets;
  if (named_button(widgets, "Open", "Also: double-click, Enter")) open(entry, TfParts::both, requests);
  if (named_button(widgets, "Colours only")) open(entry, TfParts::colors, requests);
  if (named_button(widgets, "Opacities only")) open(entry, TfParts::opacities, requests);
  if (named_button(widgets, "Duplicate", "A copy in your own folder"))
    requests.library = {LibraryChange::duplicate, entry.name, ""};
  if (!entry.is_own()) return;
  if (named_button(widgets, "Rename...")) state.library.renamed = entry.title;
  if (named_button(widgets, "Delete", "To the bin, from which your file manager brings it back"))
    requests.library = {LibraryChange::remove, entry.path, ""};
}

}  // namespace

void library_window(StudioState& state, const StudioInputs& inputs, StudioRequests& requests) {
  constexpr const char* title = "Library";
  LibraryState& library = state.library;
  if (std::exchange(library.asked, false)) {
    ImGui::OpenPopup(title);
    requests.reads_library = true;
    library = {};
  }
  center_next_window();
  const ImVec2 display = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowSize({std::floor(display.x * 0.8F), std::floor(display.y * 0.85F)},
                           ImGuiCond_Appearing);
  bool is_open = true;
  if (!ImGui::BeginPopupModal(title, &is_open,
                              ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoScrollbar))
    return;
  requests.shows_library = true;
  search_row(state, inputs.library);
  ImGui::Separator();
  const float footer = 2 * ImGui::GetFrameHeightWithSpacing() + 2 * ImGui::GetStyle().ItemSpacing.y;
  ImGui::BeginChild("cards", {0, -footer}, false, ImGuiWindowFlags_NavFlattened);
  const bool was_renaming = library.renamed.has_value();
  const LibraryEntry* chosen = cards(state, inputs.library, requests);
  ImGui::EndChild();
  ImGui::Separator();
  if (!chosen) {
    ImGui::AlignTextToFramePadding();
    ImGui::TextDisabled("Choose a preset: its picture is as it looks on %s",
                        inputs.volume ? inputs.volume->name.c_str() : "a built-in volume");
    ImGui::SameLine();
  } else if (library.renamed) {
    rename_row(state, *chosen, requests);
  } else {
    chosen_row(state, *chosen, requests);
  }
  ImGui::NewLine();
  if (named_button(state.widgets, "Add the present preset",
                   "Keeps a copy of what is being edited in your own folder"))
    requests.library = {LibraryChange::add, {}, ""};
  // In the field for a name both keys are about the name; Enter on a button presses that
  const bool is_on_widget = is_navigating() && !ImGui::GetIO().WantTextInput;
  if (chosen && !was_renaming && !is_on_widget && key_pressed(key::enter))
    open(*chosen, TfParts::both, requests);
  if (was_renaming && key_pressed(key::escape)) library.renamed.reset();
  const bool closes =
      named_button(state.widgets, "Close") || (!was_renaming && escape_pressed(state.widgets));
  if (closes || requests.open_preset) ImGui::CloseCurrentPopup();
  ImGui::EndPopup();
}

}  // namespace crest
