#include "ui/points_panel.h"

#include <fmt/core.h>

#include <algorithm>
#include <numeric>

#include "ui/curve_beneath.h"
#include "ui/move_points.h"
#include "ui/number_field.h"

namespace crest {
namespace {

std::string field_name(std::size_t row, const char* field) { return fmt::format("##point{}.{}", row, field); }

/// Ctrl adds a row or takes it away, Shift takes all from the first selected one.
void select_row(Selection& selection, std::size_t row) {
  const ImGuiIO& io = ImGui::GetIO();
  const auto place = std::ranges::lower_bound(selection, row);
  if (io.KeyCtrl && place != selection.end() && *place == row) {
    selection.erase(place);
  } else if (io.KeyCtrl) {
    selection.insert(place, row);
  } else if (io.KeyShift && !selection.empty()) {
    const std::size_t first = std::min(selection.front(), row), last = std::max(selection.front(), row);
    selection.resize(last - first + 1);
    std::iota(selection.begin(), selection.end(), first);
  } else {
    selection = {row};
  }
}

void number_cell(EditorState& editor, WidgetState& widgets, std::size_t row) {
  ImGui::AlignTextToFramePadding();
  const bool selected = std::ranges::binary_search(editor.selection, row);
  if (ImGui::Selectable(fmt::format("{}", row + 1).c_str(), selected,
                        ImGuiSelectableFlags_SpanAllColumns | ImGuiSelectableFlags_AllowItemOverlap,
                        {0, ImGui::GetFrameHeight()}))
    select_row(editor.selection, row);
  const ImVec2 low = ImGui::GetItemRectMin();
  widgets.items[fmt::format("row/point/{}", row)] = {low, {low.x + scaled(18), ImGui::GetItemRectMax().y}};
}

bool value_cell(TransferFunction& tf, EditorState& editor, WidgetState& widgets, std::size_t row) {
  double value = tf.points[row].value;
  if (!number_field(widgets, field_name(row, "value").c_str(), value,
                    value_rule(tf.points, {row}, row, editor.neighbours), -1))
    return false;
  const Moved result = moved(tf, {row}, row, value, editor.neighbours);
  editor.selection = result.of(editor.selection);
  tf.points = result.points;
  return true;
}

/// The spikes beside an edited point keep to the curve.
bool edit_point(TransferFunction& tf, std::size_t row, const ControlPoint& edited) {
  const TransferFunction before = tf;
  tf.points[row] = edited;
  keep_feet_on_curve(tf, before);
  return true;
}

bool point_row(TransferFunction& tf, EditorState& editor, WidgetState& widgets, std::size_t row) {
  const auto name = [&](const char* field) { return field_name(row, field); };
  ImGui::TableNextColumn();
  number_cell(editor, widgets, row);
  bool changed = false;
  ControlPoint point = tf.points[row];
  ImGui::TableNextColumn();
  if (color_square(widgets, name("color").c_str(), point.color)) changed |= edit_point(tf, row, point);
  ImGui::TableNextColumn();
  const bool moves = value_cell(tf, editor, widgets, row);
  ImGui::TableNextColumn();
  if (number_field(widgets, name("opacity").c_str(), point.opacity, unit_interval, -1) && !moves)
    changed |= edit_point(tf, row, point);
  ImGui::TableNextColumn();
  changed |= choice(widgets, name("surface").c_str(), tf.points[row].surface.mode, -1);
  return changed || moves;
}

}  // namespace

bool points_panel(TransferFunction& tf, EditorState& editor, WidgetState& widgets) {
  constexpr ImGuiTableFlags flags =
      ImGuiTableFlags_ScrollY | ImGuiTableFlags_BordersInnerH | ImGuiTableFlags_PadOuterX;
  if (!ImGui::BeginTable("points", 5, flags)) return false;
  const auto fixed = [](const char* name, float width) {
    ImGui::TableSetupColumn(name, ImGuiTableColumnFlags_WidthFixed, scaled(width));
  };
  ImGui::TableSetupScrollFreeze(0, 1);
  fixed("#", 30);
  fixed("##color", 22);
  ImGui::TableSetupColumn("Value", ImGuiTableColumnFlags_WidthStretch);
  ImGui::TableSetupColumn("Opacity", ImGuiTableColumnFlags_WidthStretch);
  fixed("Surface", 70);
  ImGui::TableHeadersRow();
  bool changed = false;
  ImGuiListClipper clipper;
  clipper.Begin(int(tf.points.size()));
  // What is typed in a row is not lost when the row is scrolled away.
  if (!widgets.typed.empty()) clipper.ForceDisplayRangeByIndices(0, int(tf.points.size()));
  while (clipper.Step())
    for (int row = clipper.DisplayStart; row < clipper.DisplayEnd; ++row) {
      ImGui::TableNextRow();
      changed |= point_row(tf, editor, widgets, std::size_t(row));
    }
  ImGui::EndTable();
  return changed;
}

}  // namespace crest
