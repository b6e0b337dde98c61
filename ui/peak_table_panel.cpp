#include "ui/peak_table_panel.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "ui/style.h"
#include "ui/table_regions.h"

namespace crest {
namespace {

constexpr float small_table = 132;  ///< its side, unless the person wants it large

ValueRange bin_range(const PeakTable& table, int bin) {
  const double width = table.range.width() / table.bins;
  return {table.range.min + bin * width, table.range.min + (bin + 1) * width};
}

std::string range_text(ValueRange range) { return fmt::format("{:.6g} .. {:.6g}", range.min, range.max); }

void cell_tooltip(const PeakTable& table, std::span<const Peak> surfaces, int entry, int exit) {
  ImGui::BeginTooltip();
  ImGui::TextDisabled("entry");
  ImGui::SameLine(scaled(48));
  ImGui::TextUnformatted(range_text(bin_range(table, entry)).c_str());
  ImGui::TextDisabled("exit");
  ImGui::SameLine(scaled(48));
  ImGui::TextUnformatted(range_text(bin_range(table, exit)).c_str());
  ImGui::Separator();
  const int count = table.cell(entry, exit).count;
  if (count == 0) ImGui::TextDisabled("no peak between them");
  int order = 0;
  for (const int index : peaks_met(table, entry, exit)) {
    if (index < 0) continue;
    const Peak& peak = surfaces[std::size_t(index)];
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float side = ImGui::GetFontSize();
    ImGui::GetWindowDrawList()->AddRectFilled(at, {at.x + side, at.y + side}, packed(peak.color));
    ImGui::Dummy({side, side});
    ImGui::SameLine();
    ImGui::Text("%d.  %s   opacity %s", ++order, short_text(peak.value).c_str(),
                short_text(peak.opacity).c_str());
  }
  if (count > peaks_per_cell)
    ImGui::TextColored(ImGui::ColorConvertU32ToFloat4(palette().error),
                       "%d candidates: the first %d are listed", count, peaks_per_cell);
  ImGui::EndTooltip();
}

void mark_cell(ImVec2 low, float side, const PeakTable& table, int entry, int exit) {
  const float cell = side / float(table.bins);
  const ImVec2 corner{low.x + float(entry) * cell, low.y + float(table.bins - 1 - exit) * cell};
  ImGui::GetWindowDrawList()->AddRect({corner.x - 1, corner.y - 1},
                                      {corner.x + cell + 1, corner.y + cell + 1}, palette().emphasis);
}

void draw_picture(ImDrawList& list, ImVec2 low, float side, const PeakTable& table,
                  std::span<const Peak> surfaces) {
  const ImU32 no_peak = palette().empty_cell;
  const float cell = side / float(table.bins);
  const auto edge = [&](int entry, int exit) {
    return ImVec2(low.x + float(entry) * cell, low.y + float(table.bins - exit) * cell);
  };
  list.AddRectFilled(low, {low.x + side, low.y + side}, no_peak);
  for (const TableRegion& region : table_regions(table))
    list.AddRectFilled(edge(region.first_entry, region.last_exit + 1),
                       edge(region.last_entry + 1, region.first_exit),
                       packed(surfaces[std::size_t(region.peak)].color));
  list.AddRect(low, {low.x + side, low.y + side}, palette().frame);
}

void hover_cell(StudioState& state, const PeakTable& table, std::span<const Peak> surfaces, ImVec2 low,
                float side) {
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const auto bin = [&](float share) { return std::clamp(int(share * float(table.bins)), 0, table.bins - 1); };
  const int entry = bin((mouse.x - low.x) / side), exit = bin(1 - (mouse.y - low.y) / side);
  mark_cell(low, side, table, entry, exit);
  cell_tooltip(table, surfaces, entry, exit);
  state.under_cursor = fmt::format("entry {}   exit {}", range_text(bin_range(table, entry)),
                                   range_text(bin_range(table, exit)));
}

/// Where a ray's steps lie in the table: the values at their two ends, from step to step.
void draw_path(ImDrawList& list, ImVec2 low, float side, ValueRange range, const InspectedRay& ray) {
  if (ray.steps.size() < 3) return;
  const auto along = [&](double value) { return float((value - range.min) / range.width()) * side; };
  std::vector<ImVec2> path;
  for (std::size_t i = 1; i < ray.steps.size(); ++i) {
    const double entry = ray.exact.value_at(ray.steps[i - 1].depth),
                 exit = ray.exact.value_at(ray.steps[i].depth);
    if (!std::isnan(entry) && !std::isnan(exit))
      path.push_back({low.x + along(entry), low.y + side - along(exit)});
  }
  list.PushClipRect(low, {low.x + side, low.y + side}, true);
  list.AddPolyline(path.data(), int(path.size()), palette().curve, ImDrawFlags_None, 1);
  for (const ImVec2 at : path) list.AddCircleFilled(at, scaled(1.5F), palette().emphasis);
  list.PopClipRect();
}

/// Text turned to be read from below; `place` is where it begins, at the left of its letters' tops.
void draw_upwards(ImDrawList& list, ImVec2 place, const char* text) {
  const int first = list.VtxBuffer.Size;
  list.AddText(place, palette().secondary, text);
  for (ImDrawVert* v = list.VtxBuffer.Data + first; v != list.VtxBuffer.Data + list.VtxBuffer.Size; ++v)
    v->pos = {place.x + (v->pos.y - place.y), place.y - (v->pos.x - place.x)};
}

void facts(const PeakTable& table, bool large) {
  ImGui::BeginGroup();
  ImGui::Text("%d x %d", table.bins, table.bins);
  ImGui::TextDisabled("entry and exit values");
  ImGui::Spacing();
  const int largest = table.largest_count();
  ImGui::Text("%d", largest);
  ImGui::TextDisabled("%s", largest == 1 ? "peak in the fullest cell" : "peaks in the fullest cell");
  ImGui::Spacing();
  ImGui::TextDisabled("A cell has the colour of the");
  ImGui::TextDisabled("peak that a ray meets first");
  ImGui::TextDisabled("between the two values.");
  ImGui::TextDisabled("Click it: %s", large ? "small again" : "as large as there is room");
  ImGui::EndGroup();
}

}  // namespace

void peak_table_panel(const Document& document, StudioState& state, const StudioInputs& inputs) {
  if (!inputs.volume || inputs.surfaces.size() > std::size_t(most_table_peaks)) {
    ImGui::TextDisabled(inputs.volume
                            ? "There are too many surfaces for a table."
                            : "The table of entry and exit values comes with a volume: Ctrl+O opens one.");
    return;
  }
  const PeakTable table =
      build_peak_table(inputs.surfaces, inputs.volume->statistics.range, document.preset.rendering.peak_bins);
  const ImVec2 room = ImGui::GetContentRegionAvail(), corner = ImGui::GetCursorScreenPos();
  const float line = ImGui::GetFontSize(), gutter = line + scaled(6), strip = line + scaled(8);
  const float whole = std::floor(std::min(room.x - gutter - scaled(8), room.y - strip - scaled(4)));
  const float side = state.settings.large_peak_table ? whole : std::min(whole, scaled(small_table));
  if (side < scaled(40)) return;
  const ImVec2 low{corner.x + gutter, corner.y};
  ImGui::SetCursorScreenPos(low);
  if (ImGui::InvisibleButton("##peak table", {side, side}))
    state.settings.large_peak_table = !state.settings.large_peak_table;
  note_item(state.widgets, "peak table");
  const bool hovered = ImGui::IsItemHovered();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  draw_picture(list, low, side, table, inputs.surfaces);
  const std::size_t mode = std::size_t(std::ranges::find(view_modes, state.ray.mode) - view_modes.begin());
  if (state.ray.ask && inputs.ray && inputs.ray->modes[mode])
    draw_path(list, low, side, table.range, *inputs.ray->modes[mode]);
  const auto text_width = [](const std::string& text) { return ImGui::CalcTextSize(text.c_str()).x; };
  const std::string least = short_text(table.range.min), most = short_text(table.range.max);
  const float text_y = low.y + side + scaled(4);
  list.AddText({low.x, text_y}, palette().secondary, least.c_str());
  list.AddText({low.x + side - text_width(most), text_y}, palette().secondary, most.c_str());
  const bool roomy =
      std::max(text_width(least), text_width(most)) + scaled(8) < (side - text_width("entry value")) / 2;
  if (roomy)
    list.AddText({low.x + (side - text_width("entry value")) / 2, text_y}, palette().secondary,
                 "entry value");
  draw_upwards(list, {corner.x, low.y + (side + text_width("exit value")) / 2}, "exit value");
  if (room.x - gutter - side > scaled(190)) {
    ImGui::SetCursorScreenPos({low.x + side + scaled(16), low.y});
    facts(table, state.settings.large_peak_table);
  }
  if (hovered) hover_cell(state, table, inputs.surfaces, low, side);
}

}  // namespace crest
