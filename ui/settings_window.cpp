#include "ui/settings_window.h"

#include <fmt/core.h>

#include <array>

#include "ui/questions.h"
#include "ui/style.h"

namespace crest {
namespace {

constexpr const char* title = "Settings";
constexpr std::array scales{0.75, 1.0, 1.25, 1.5, 1.75, 2.0, 2.5, 3.0};

std::string scale_text(std::optional<double> scale) {
  return scale ? fmt::format("{:.4g} %", 100 * *scale) : "as the screen says";
}

void theme_row(WidgetState& widgets, StudioSettings& settings) {
  const auto button = [&](const char* text, Theme theme) {
    if (ImGui::RadioButton(text, settings.theme == theme)) settings.theme = theme;
    note_item(widgets, fmt::format("theme/{}", text));
  };
  button("dark", Theme::dark);
  ImGui::SameLine();
  button("light", Theme::light);
}

void scale_row(WidgetState& widgets, StudioSettings& settings) {
  const auto option = [&](std::optional<double> scale) {
    const std::string text = scale_text(scale);
    if (ImGui::Selectable(text.c_str(), settings.scale == scale)) settings.scale = scale;
    note_item(widgets, "scale/" + text);
  };
  ImGui::SetNextItemWidth(scaled(200));
  const bool open =
      ImGui::BeginCombo("##scale", scale_text(settings.scale).c_str(), ImGuiComboFlags_HeightLarge);
  note_item(widgets, "##scale");
  if (!open) return;
  option({});
  for (const double scale : scales) option(scale);
  ImGui::EndCombo();
}

}  // namespace

void settings_window(StudioState& state) {
  if (std::exchange(state.settings_asked, false)) ImGui::OpenPopup(title);
  center_next_window();
  bool open = true;
  if (!ImGui::BeginPopupModal(title, &open, ImGuiWindowFlags_AlwaysAutoResize)) return;
  StudioSettings& settings = state.settings;
  if (ImGui::BeginTable("settings", 2)) {
    ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthFixed, scaled(150));
    ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthFixed, scaled(260));
    const auto row = [](const char* text) {
      ImGui::TableNextRow();
      ImGui::TableNextColumn();
      ImGui::AlignTextToFramePadding();
      ImGui::TextDisabled("%s", text);
      ImGui::TableNextColumn();
    };
    row("Colours");
    theme_row(state.widgets, settings);
    row("Size of text");
    scale_row(state.widgets, settings);
    ImGui::EndTable();
  }
  ImGui::Spacing();
  ImGui::TextDisabled("Kept for the next start.");
  ImGui::Spacing();
  if (ImGui::Button("Close", {scaled(104), 0}) || escape_pressed(state.widgets)) ImGui::CloseCurrentPopup();
  note_item(state.widgets, "close settings");
  ImGui::EndPopup();
}

}  // namespace crest
