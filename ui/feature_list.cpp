#include "ui/feature_list.h"
#include "ui/mode_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace crest {
namespace {

/// The enlarged view's mode, since no other is drawn; or the one that was chosen.
Mode listed_mode(const ViewsState& views, Mode preset_mode) {
  if (views.enlarged >= 0) return views.contents[std::size_t(views.enlarged)].mode;
  return views.listed.value_or(preset_mode);
}

void mode_row(StudioState& state, Mode listed) {
  ImGui::BeginDisabled(state.views.enlarged >= 0);
  for (const Mode mode : view_modes) {
    const std::string name(name_of(mode));
    ImGui::PushStyleColor(
        ImGuiCol_Button, ImGui::GetStyleColorVec4(mode == listed ? ImGuiCol_HeaderActive : ImGuiCol_FrameBg));
    if (ImGui::Button(fmt::format("{}##listed", title_of(mode)).c_str())) state.views.listed = mode;
    ImGui::PopStyleColor();
    note_item(state.widgets, "listed/" + name);
    tip((name + " in files").c_str());
    ImGui::SameLine(0, scaled(3));
  }
  ImGui::EndDisabled();
  ImGui::NewLine();
}

std::string bytes_text(std::size_t bytes) {
  static constexpr const char* units[] = {"bytes", "KiB", "MiB", "GiB"};
  double size = double(bytes);
  std::size_t unit = 0;
  for (; size >= 1024 && unit + 1 < std::size(units); ++unit) size /= 1024;
  return fmt::format("{:.4g} {}", size, units[unit]);
}

using Names = std::vector<std::string>;

/// What was left out for the same reason, together.
std::vector<std::pair<std::string, Names>> by_reason(const FeatureList& features) {
  std::vector<std::pair<std::string, Names>> reasons;
  for (const auto& [name, why] : features.left_out) {
    const auto found = std::ranges::find(reasons, why, &std::pair<std::string, Names>::first);
    if (found != reasons.end())
      found->second.push_back(name);
    else
      reasons.push_back({why, {name}});
  }
  return reasons;
}

void draw_rows(WidgetState& widgets, const std::vector<FeatureRow>& rows) {
  if (!ImGui::BeginTable("features", 2, ImGuiTableFlags_SizingStretchProp)) return;
  ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthFixed, scaled(140));
  ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthStretch);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const FeatureRow& row = rows[i];
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    if (i == 0 || row.name != rows[i - 1].name) ImGui::TextDisabled("%s", row.name.c_str());
    ImGui::TableNextColumn();
    ImGui::PushStyleColor(ImGuiCol_Text,
                          ImGui::GetStyleColorVec4(row.is_in ? ImGuiCol_Text : ImGuiCol_TextDisabled));
    ImGui::TextWrapped("%s", row.text.c_str());
    ImGui::PopStyleColor();
    note_item(widgets, fmt::format("row/{}", row.text));
  }
  ImGui::EndTable();
}

}  // namespace

std::vector<FeatureRow> feature_rows(const PictureNeed& need) {
  const auto& in = need.features.in;
  std::vector<FeatureRow> rows{
      {"made of", in.empty() ? "nothing" : fmt::format("{}", fmt::join(in, ", ")), true}};
  for (const std::string& note : need.features.notes) rows.push_back({"but", note, true});
  for (const GpuData& data : need.gpu_data)
    rows.push_back({data.name, fmt::format("{}, {}", data.size, bytes_text(data.bytes)), true});
  for (const auto& [why, names] : by_reason(need.features))
    rows.push_back({"left out", fmt::format("{}: {}", fmt::join(names, ", "), why), false});
  return rows;
}

void feature_list(StudioState& state, const StudioInputs& inputs, Mode preset_mode) {
  const bool open = ImGui::CollapsingHeader("What the picture is made of");
  note_item(state.widgets, "features");
  if (open && ImGui::IsItemToggledOpen()) ImGui::SetScrollHereY(0);  // what was opened lies below
  tip("What this scene needs of the renderer, what the graphics device holds for it,\nand what was left out, "
      "and why");
  if (!open) return;
  const Mode listed = listed_mode(state.views, preset_mode);
  mode_row(state, listed);
  const auto view = std::ranges::find(state.views.contents, listed, &ViewContent::mode);
  if (view == state.views.contents.end()) return ImGui::TextDisabled("no view shows it");
  const PictureNeed& need = inputs.views[std::size_t(view - state.views.contents.begin())].need;
  if (need == PictureNeed{}) return ImGui::TextDisabled("not drawn yet");
  draw_rows(state.widgets, feature_rows(need));
}

}  // namespace crest
