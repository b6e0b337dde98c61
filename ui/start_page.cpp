#include "ui/start_page.h"

#include <fmt/core.h>

#include "ui/actions.h"
#include "ui/card.h"
#include "ui/examples.h"
#include "ui/questions.h"
#include "ui/style.h"

namespace crest {
namespace {

/// "head.nrrd", "/scans" of "/scans/head.nrrd"; a query stays with the name.
std::pair<std::string, std::string> name_and_folder(const std::string& source) {
  const std::size_t slash = source.substr(0, source.find('?')).rfind('/');
  if (slash == source.npos || slash + 1 == source.size()) return {source, ""};
  return {source.substr(slash + 1), source.substr(0, std::max<std::size_t>(slash, 1))};
}

void section(const char* text) {
  ImGui::Dummy({0, scaled(10)});
  heading(text);
  ImGui::Dummy({0, scaled(2)});
}

void opening(const Document& document, StudioState& state) {
  ImGui::PushFont(font_of(TextSize::title));
  ImGui::TextUnformatted("Crest");
  ImGui::PopFont();
  ImGui::TextDisabled("Open a volume, or drop a file anywhere on this window.");
  ImGui::Spacing();
  const ImVec2 size{scaled(126), scaled(32)};
  const auto button = [&](const char* text, FilePurpose purpose) {
    if (ImGui::Button(text, size)) ask_for_file(state, document, purpose);
    if (purpose == FilePurpose::open_volume) take_focus(state.navigation, Area::views);
    note_item(state.widgets, fmt::format("start/{}", text));
    tip(key_text_of(text).c_str());
  };
  button("Open volume...", FilePurpose::open_volume);
  ImGui::SameLine();
  button("Open preset...", FilePurpose::open_preset);
  ImGui::SameLine();
  if (ImGui::Button("Library...", size)) state.library.asked = true;
  note_item(state.widgets, "start/Library...");
  tip(key_text_of("Library...").c_str());
}

void example_cards(StudioState& state, const StudioInputs& inputs, StudioRequests& requests) {
  const int columns = column_count();
  for (int i = 0; i < int(examples().size()); ++i) {
    const Example& example = examples()[std::size_t(i)];
    const std::size_t at = std::size_t(i);
    place_card(i, columns);
    const Card what{fmt::format("example/{}", i),
                    at < inputs.example_pictures.size() ? inputs.example_pictures[at] : 0, example.title,
                    example.shows, fmt::format("{} with the preset {}", example.volume, example.preset)};
    if (!card(state.widgets, what)) continue;
    requests.open_volume = example.volume;
    requests.open_preset = example.preset;
  }
}

void recent_cards(StudioState& state, const StudioInputs& inputs, StudioRequests& requests) {
  const int columns = column_count();
  for (int i = 0; i < int(inputs.recent.size()); ++i) {
    const std::string& source = inputs.recent[std::size_t(i)];
    const std::size_t at = std::size_t(i);
    const auto [name, folder] = name_and_folder(source);
    place_card(i, columns);
    const Card what{fmt::format("recent/{}", i),
                    at < inputs.recent_pictures.size() ? inputs.recent_pictures[at] : 0, name,
                    folder.empty()
                        ? "built-in volume"
                        : fmt::format("{} in {}", is_preset_name(source) ? "preset" : "volume", folder),
                    source};
    if (card(state.widgets, what))
      (is_preset_name(source) ? requests.open_preset : requests.open_volume) = source;
  }
}

}  // namespace

void start_page(const Document& document, StudioState& state, const StudioInputs& inputs,
                StudioRequests& requests) {
  requests.shows_start_page = true;
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {scaled(20), scaled(16)});
  ImGui::BeginChild("start page", {0, 0}, false,
                    ImGuiWindowFlags_AlwaysUseWindowPadding | ImGuiWindowFlags_NavFlattened);
  ImGui::PopStyleVar();
  opening(document, state);
  section("Examples");
  example_cards(state, inputs, requests);
  if (!inputs.recent.empty()) {
    section("Recent");
    recent_cards(state, inputs, requests);
  }
  ImGui::EndChild();
}

}  // namespace crest
