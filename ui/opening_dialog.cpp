#include "ui/opening_dialog.h"

#include <fmt/core.h>
#include <imgui_internal.h>

#include <algorithm>
#include <filesystem>

#include "ui/navigation.h"
#include "ui/number_field.h"
#include "ui/part_form.h"
#include "ui/questions.h"
#include "ui/raw_form.h"
#include "ui/style.h"

namespace crest {
namespace {

constexpr int most_rows = 64;  ///< of a list; more have a slider

/// "Which frame of heart.nrrd?"; the same window for each.
std::string title_of(const OpenChoice& choice) {
  const std::filesystem::path path = choice.path;
  const std::string name = (path.has_filename() ? path : path.parent_path()).filename().string();
  if (choice.kind == ChoiceKind::raw_layout) return fmt::format("What is in {}?###opening", name);
  if (choice.kind == ChoiceKind::part) return fmt::format("{} is too large###opening", name);
  return fmt::format("Which {} of {}?###opening", key_of(choice.kind), name);
}

std::string text_of(const OpenChoice& choice, int i) {
  if (std::size_t(i) < choice.options.size()) return choice.options[std::size_t(i)].text;
  return fmt::format("{} {}", key_of(choice.kind), i);
}

void step(OpeningState& opening, ImGuiKey key, int by, int last) {
  if (ImGui::IsAnyItemActive() || !ImGui::IsKeyPressed(ImGui::GetKeyIndex(key))) return;
  opening.chosen = std::clamp(opening.chosen + by, 0, last);
  opening.scroll = true;
  keep_focus();
}

/// Returns whether a double-click opens one.
bool list_of_options(StudioState& state, const OpenChoice& choice) {
  OpeningState& opening = state.opening;
  const int count = int(choice.count);
  const float row = ImGui::GetTextLineHeightWithSpacing();
  bool opens = false;
  ImGui::PushItemFlag(ImGuiItemFlags_NoNav, true);  // arrows choose in it, wherever the focus is
  ImGui::BeginChild("options", {0, std::min(float(count), 12.0F) * row + scaled(16)}, true);
  step(opening, ImGuiKey_UpArrow, -1, count - 1);
  step(opening, ImGuiKey_DownArrow, 1, count - 1);
  for (int i = 0; i < count; ++i) {
    const std::string label = fmt::format("{}##{}", text_of(choice, i), i);
    constexpr auto flags = ImGuiSelectableFlags_DontClosePopups | ImGuiSelectableFlags_AllowDoubleClick;
    if (ImGui::Selectable(label.c_str(), opening.chosen == i, flags)) {
      opening.chosen = i;
      opens |= ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left);
    }
    note_item(state.widgets, fmt::format("option/{}", i));
    if (opening.scroll && opening.chosen == i) ImGui::SetScrollHereY();
  }
  opening.scroll = false;
  ImGui::EndChild();
  ImGui::PopItemFlag();
  return opens;
}

void slider_of_options(StudioState& state, const OpenChoice& choice) {
  const int last = int(std::min<std::uint64_t>(choice.count, std::uint64_t(1) << 30)) - 1;
  int& chosen = state.opening.chosen;
  step(state.opening, ImGuiKey_LeftArrow, -1, last);
  step(state.opening, ImGuiKey_RightArrow, 1, last);
  ImGui::SetNextItemWidth(scaled(360));
  ImGui::SliderInt("##option slider", &chosen, 0, last, "", ImGuiSliderFlags_AlwaysClamp);
  note_item(state.widgets, "option slider");
  ImGui::SameLine();
  integer_field(state.widgets, "##option", chosen, 0, last, scaled(90));
  ImGui::SameLine();
  ImGui::TextDisabled("0 to %d", last);
}

/// Returns whether the chosen one is to be opened.
bool options(StudioState& state, const OpenChoice& choice) {
  const std::string_view key = key_of(choice.kind);
  ImGui::TextUnformatted(fmt::format("It has {} {}{}, and a volume is one of them.", choice.count, key,
                                     choice.kind == ChoiceKind::series ? "" : "s")
                             .c_str());
  ImGui::Spacing();
  if (choice.count <= std::uint64_t(most_rows)) return list_of_options(state, choice);
  slider_of_options(state, choice);
  return false;
}

void begin(OpeningState& opening, const Opening& asked) {
  const OpenChoice& choice = asked.choice;
  opening = {};
  opening.about = choice;
  if (choice.kind == ChoiceKind::raw_layout) begin_raw_form(opening, asked);
  if (choice.kind == ChoiceKind::part) begin_part_form(opening, choice);
}

/// What the form says, as a source.
std::string chosen_source_of(const OpeningState& opening, const OpenChoice& choice) {
  if (choice.kind == ChoiceKind::raw_layout)
    return source_of(choice.path, query_of(opening.layout, choice.query));
  if (choice.kind == ChoiceKind::part) return source_with_part(opening, choice);
  return chosen_source(choice, std::uint64_t(opening.chosen));
}

}  // namespace

void opening_dialog(StudioState& state, const StudioInputs& inputs, StudioRequests& requests) {
  OpeningState& opening = state.opening;
  if (!inputs.opening) {
    opening.about.reset();
    return;
  }
  const OpenChoice& choice = inputs.opening->choice;
  const std::string title = title_of(choice);
  if (opening.about != choice) begin(opening, *inputs.opening);
  open_when_free(title.c_str());
  center_next_window();
  if (!ImGui::BeginPopupModal(title.c_str(), nullptr,
                              ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_AlwaysAutoResize))
    return;
  bool opens = false, can_open = true;
  if (choice.kind == ChoiceKind::raw_layout)
    can_open = raw_form(state, *inputs.opening, requests);
  else if (choice.kind == ChoiceKind::part)
    can_open = part_form(state, choice);
  else
    opens = options(state, choice);
  ImGui::Spacing();
  ImGui::BeginDisabled(!can_open);
  opens |= default_button("Open##chosen", {scaled(104), 0});
  ImGui::EndDisabled();
  note_item(state.widgets, "open chosen");
  ImGui::SameLine();
  const bool closes = ImGui::Button("Cancel##opening", {scaled(104), 0});
  note_item(state.widgets, "cancel opening");
  if (opens && can_open)
    requests.open_volume = chosen_source_of(opening, choice);
  else if (closes || escape_pressed(state.widgets))
    requests.cancel_opening = true;
  if (requests.open_volume || requests.cancel_opening) ImGui::CloseCurrentPopup();
  ImGui::EndPopup();
}

}  // namespace crest
