#include "ui/peaks_panel.h"

#include <fmt/core.h>

#include <algorithm>
#include <numeric>

#include "ui/edit_points.h"
#include "ui/number_field.h"
#include "ui/style.h"

namespace crest {
namespace {

/// The points of a peak's top.
Selection top_of(const Peak& peak) {
  Selection top;
  for (std::size_t i = peak.first_point; i <= peak.last_point; ++i) top.push_back(i);
  return top;
}

std::string field_name(std::size_t row, const char* field) { return fmt::format("##peak{}.{}", row, field); }

bool value_cell(TransferFunction& tf, EditorState& editor, const Peak& peak, std::size_t row,
                WidgetState& widgets) {
  const Selection top = top_of(peak);
  double value = std::midpoint(tf.points[peak.first_point].value, tf.points[peak.last_point].value);
  const double before = value;
  if (!number_field(widgets, field_name(row, "value").c_str(), value, any_value, -1)) return false;
  const double first = tf.points[top[0]].value;
  const double to = top.size() == 1 ? value : first + (value - before);
  const Moved result = moved(tf, whole_of(tf, top), top[0], to, editor.neighbours);
  editor.selection = result.of(editor.selection);
  tf.points = result.points;
  return true;
}

/// The surface's own opacity if it has one, or the points'.
bool opacity_cell(TransferFunction& tf, const Peak& peak, std::size_t row, WidgetState& widgets) {
  ControlPoint& point = tf.points[peak.first_point];
  double opacity = point.surface.opacity.value_or(point.opacity);
  if (!number_field(widgets, field_name(row, "opacity").c_str(), opacity, unit_interval, -1)) return false;
  for (const std::size_t i : top_of(peak)) {
    if (tf.points[i].surface.opacity)
      tf.points[i].surface.opacity = opacity;
    else
      tf.points[i].opacity = opacity;
  }
  return true;
}

bool width_cell(TransferFunction& tf, const Peak& peak, std::size_t row, WidgetState& widgets) {
  if (!peak.detected) {
    ImGui::TextDisabled("-");
    return false;
  }
  double width = peak_width(tf, peak);
  if (!number_field(widgets, field_name(row, "width").c_str(), width, not_negative, -1)) return false;
  set_peak_width(tf, peak, width);
  return true;
}

bool peak_row(TransferFunction& tf, EditorState& editor, WidgetState& widgets, const Peak& peak,
              std::size_t row) {
  bool changed = false;
  const bool selected = !editor.selection.empty() && editor.selection.front() >= peak.first_point &&
                        editor.selection.front() <= peak.last_point;
  ImGui::TableNextColumn();
  ImGui::AlignTextToFramePadding();
  if (ImGui::Selectable(fmt::format("{}", row + 1).c_str(), selected,
                        ImGuiSelectableFlags_SpanAllColumns | ImGuiSelectableFlags_AllowItemOverlap,
                        {0, ImGui::GetFrameHeight()}))
    editor.selection = top_of(peak);
  note_item(widgets, fmt::format("peak{}", row));
  ImGui::TableNextColumn();
  if (color_square(widgets, field_name(row, "color").c_str(), tf.points[peak.first_point].color)) {
    for (const std::size_t i : top_of(peak)) tf.points[i].color = tf.points[peak.first_point].color;
    changed = true;
  }
  ImGui::TableNextColumn();
  changed |= value_cell(tf, editor, peak, row, widgets);
  ImGui::TableNextColumn();
  changed |= opacity_cell(tf, peak, row, widgets);
  ImGui::TableNextColumn();
  changed |= width_cell(tf, peak, row, widgets);
  ImGui::TableNextColumn();
  SurfaceMode mode = tf.points[peak.first_point].surface.mode;
  if (choice(widgets, field_name(row, "surface").c_str(), mode, -1)) {
    for (const std::size_t i : top_of(peak)) tf.points[i].surface.mode = mode;
    changed = true;
  }
  ImGui::TableNextColumn();
  ImGui::AlignTextToFramePadding();
  ImGui::TextDisabled("%s", !peak.detected ? "point" : peak.spike ? "spike" : "wide");
  tip(!peak.detected ? "Made a surface by hand"
      : peak.spike   ? "Narrow: as a surface, it is taken out of the volume rendering"
                     : "Its body stays in the volume rendering");
  return changed;
}

void columns() {
  const auto fixed = [](const char* name, float width) {
    ImGui::TableSetupColumn(name, ImGuiTableColumnFlags_WidthFixed, scaled(width));
  };
  ImGui::TableSetupScrollFreeze(0, 1);
  fixed("#", 22);
  fixed("##color", 22);
  ImGui::TableSetupColumn("Value", ImGuiTableColumnFlags_WidthStretch, 1.2F);
  ImGui::TableSetupColumn("Opacity", ImGuiTableColumnFlags_WidthStretch, 0.9F);
  ImGui::TableSetupColumn("Width", ImGuiTableColumnFlags_WidthStretch, 1);
  fixed("Surface", 66);
  fixed("Kind", 42);
  ImGui::TableHeadersRow();
}

}  // namespace

bool peaks_panel(Document& document, StudioState& state, const StudioInputs& inputs, float height) {
  TransferFunction& tf = document.preset.transfer_function;
  if (inputs.peaks.empty()) {
    ImGui::TextDisabled("No peaks: a point higher than both its neighbours is one.");
    ImGui::TextDisabled("Any point can be made a surface: right-click it.");
    return false;
  }
  constexpr ImGuiTableFlags flags =
      ImGuiTableFlags_ScrollY | ImGuiTableFlags_BordersInnerH | ImGuiTableFlags_PadOuterX;
  if (!ImGui::BeginTable("peaks", 7, flags, {0, height})) return false;
  columns();
  bool changed = false;
  std::vector<const Peak*> rows;
  for (const Peak& peak : inputs.peaks)  // found before the last edit, perhaps of points that are gone
    if (std::max(peak.right, peak.last_point) < tf.points.size()) rows.push_back(&peak);
  ImGuiListClipper clipper;
  clipper.Begin(int(rows.size()));
  while (clipper.Step())
    for (int row = clipper.DisplayStart; row < clipper.DisplayEnd; ++row) {
      ImGui::TableNextRow();
      changed |= peak_row(tf, state.editor, state.widgets, *rows[std::size_t(row)], std::size_t(row));
    }
  ImGui::EndTable();
  return changed;
}

}  // namespace crest
