#include "ui/accuracy_table.h"

#include <fmt/core.h>

#include <algorithm>

#include "ui/style.h"

namespace crest {
namespace {

/// A method: its order of convergence, and its cheapest setting that meets the target.
bool method_row(Document& document, StudioState& state, const ShownAccuracy& shown, const MethodLine& line) {
  const auto found = std::ranges::find(shown.convergences, line.method->id, &MethodConvergence::method);
  if (found == shown.convergences.end()) return false;
  const auto& cheapest = found->cheapest;
  ImGui::TableNextColumn();
  const std::string name(line.method->name);
  const float mark = ImGui::GetFontSize();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const bool clicked = ImGui::Selectable(("##method " + name).c_str(), shown.present == line.method,
                                         ImGuiSelectableFlags_SpanAllColumns);
  note_item(state.widgets, fmt::format("method/{}", line.method->id));
  if (ImGui::IsItemHovered()) state.accuracy.hovered_method = line.method->id;
  tip(!cheapest ? "No setting that was measured meets the target"
      : !found->steady
          ? "Click to render with its cheapest setting that meets the target.\n* Some finer steps miss "
            "it again: this one may owe it to chance."
          : "Click to render with its cheapest setting that meets the target");
  ImDrawList& list = *ImGui::GetWindowDrawList();
  draw_mark(list, {at.x + mark / 2, at.y + mark / 2}, scaled(4), *line.method, true);
  list.AddText({at.x + mark + scaled(6), at.y}, palette().text, name.c_str());
  ImGui::TableNextColumn();
  ImGui::TextDisabled("%s", found->fit ? fmt::format("{:.2f}", found->fit->order).c_str() : "-");
  ImGui::TableNextColumn();
  if (!cheapest) {
    ImGui::TextDisabled("-");
    ImGui::TableNextColumn();
    ImGui::TextDisabled("-");
    return false;
  }
  const Measurement& m = shown.results.measured[*cheapest];
  ImGui::TextDisabled("%s%s", line.method->has_step ? step_text(m.step).c_str() : "-",
                      found->steady ? "" : " *");
  ImGui::TableNextColumn();
  const ImU32 color = shown.recommended == cheapest ? palette().good : palette().text;
  ImGui::TextColored(ImGui::ColorConvertU32ToFloat4(color), "%s", ms_text(m.frame_ms).c_str());
  return clicked && apply_setting(document, state.accuracy, shown, *cheapest);
}

void table_head() {
  static constexpr std::pair<const char*, const char*> columns[] = {
      {"Method", "A click on a row takes its cheapest setting that meets the target"},
      {"Order",
       "Of convergence: the slope of log(RMSE) over log(step), fitted at the finest steps\nwhere the error "
       "is a power of the step"},
      {"Step", "Of the cheapest setting that meets the target"},
      {"ms", "A frame at that step"}};
  ImGui::TableSetupColumn(columns[0].first, ImGuiTableColumnFlags_WidthStretch);
  for (std::size_t i = 1; i < std::size(columns); ++i)
    ImGui::TableSetupColumn(columns[i].first, ImGuiTableColumnFlags_WidthFixed, scaled(54));
  ImGui::TableNextRow(ImGuiTableRowFlags_Headers);
  for (const auto& [name, meaning] : columns) {
    ImGui::TableNextColumn();
    ImGui::TableHeader(name);
    tip(meaning);
  }
}

}  // namespace

bool accuracy_table(Document& document, StudioState& state, const ShownAccuracy& shown) {
  state.accuracy.hovered_method = {};
  if (shown.lines.empty()) return false;
  constexpr ImGuiTableFlags flags = ImGuiTableFlags_BordersInnerH | ImGuiTableFlags_PadOuterX;
  if (!ImGui::BeginTable("methods", 4, flags)) return false;
  table_head();
  bool changed = false;
  for (const MethodLine& line : shown.lines) changed |= method_row(document, state, shown, line);
  ImGui::EndTable();
  return changed;
}

}  // namespace crest
