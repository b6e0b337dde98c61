#include "ui/peaks_panel.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>

#include "ui/curve_beneath.h"
#include "ui/edit_peaks.h"
#include "ui/number_field.h"
#include "ui/style.h"

namespace crest {
namespace {

std::string field_name(std::size_t row, const char* field) { return fmt::format("##peak{}.{}", row, field); }

bool value_cell(TransferFunction& tf, EditorState& editor, const Peak& peak, std::size_t row,
                WidgetState& widgets) {
  const Selection top = top_of(peak);
  double value = std::midpoint(tf.points[peak.first_point].value, tf.points[peak.last_point].value);
  const double before = value;
  const double first = tf.points[top[0]].value;
  FieldRule rule = value_rule(tf.points, whole_of(tf, top), top[0], editor.neighbours);
  if (top.size() > 1) {  // the field is about their middle
    rule.min += before - first;
    rule.max += before - first;
  }
  if (!number_field(widgets, field_name(row, "value").c_str(), value, rule, -1)) return false;
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
  const auto dragged = [](double from, double pixels) {
    return round_to_resolution(from + pixels / 200, 0.05);
  };
  if (!drag_field(widgets, field_name(row, "opacity").c_str(), opacity, unit_interval, -1, dragged))
    return false;
  edit_above_curve(tf, [&] {
    for (const std::size_t i : top_of(peak)) {
      if (tf.points[i].surface.opacity)
        tf.points[i].surface.opacity = opacity;
      else
        tf.points[i].opacity = opacity;
    }
  });
  return true;
}

bool width_cell(TransferFunction& tf, EditorState& editor, const Peak& peak, std::size_t row,
                WidgetState& widgets) {
  if (!peak.detected) {
    ImGui::TextDisabled("-");
    return false;
  }
  double width = peak_width(tf, peak);
  // By factors, as widths are told apart; what is 0 begins with a thousandth of a spike's.
  const double least = 1e-3 * widest_spike(tf);
  const auto dragged = [&](double from, double pixels) {
    const double to = std::max(from, least) * std::pow(1.02, pixels);
    return to < least ? 0 : round_to_resolution(to, 0.1 * to);
  };
  const bool changed =
      drag_field(widgets, field_name(row, "width").c_str(), width, not_negative, -1, dragged);
  if (ImGui::IsItemActivated()) editor.before_width = tf;
  if (!changed) return false;
  // Each frame of a drag starts from the points at its beginning: flanks of no width have no proportions
  if (ImGui::IsItemActive() && editor.before_width.points.size() == tf.points.size())
    tf = editor.before_width;
  const std::vector<Peak> peaks = find_peaks(tf);
  const auto as_it_was = std::ranges::find(peaks, peak.first_point, &Peak::first_point);
  set_peak_width(tf, as_it_was == peaks.end() ? peak : *as_it_was, width);
  return true;
}

void draw_eye(ImDrawList& list, ImVec2 middle, bool open, ImU32 color) {
  const float half = scaled(6);
  constexpr int parts = 12;
  const auto lid = [&](float side) {
    for (int i = 0; i <= parts; ++i) {
      const float t = float(i) / parts * 2 - 1;
      list.PathLineTo({middle.x + t * half, middle.y + side * half * 0.6F * (1 - t * t)});
    }
    list.PathStroke(color, ImDrawFlags_None, 1.2F);
  };
  lid(1);
  if (!open) return;
  lid(-1);
  list.AddCircleFilled(middle, scaled(2.2F), color);
}

/// A button as large as a line of text, without a frame.
bool small_button(WidgetState& widgets, const std::string& name, const char* text, const char* meaning) {
  ImGui::PushStyleColor(ImGuiCol_Button, ImVec4(0, 0, 0, 0));
  const bool pressed =
      ImGui::Button(fmt::format("{}##{}", text, name).c_str(), {scaled(18), ImGui::GetFrameHeight()});
  ImGui::PopStyleColor();
  note_item(widgets, name);
  tip(meaning);
  return pressed;
}

bool eye_cell(TransferFunction& tf, const Peak& peak, std::size_t row, WidgetState& widgets) {
  const bool pressed = small_button(
      widgets, fmt::format("peak{}.eye", row), "",
      peak.shown ? "Shown as a surface: a click hides it" : "Not shown as a surface: a click shows it");
  const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
  draw_eye(*ImGui::GetWindowDrawList(), {(low.x + high.x) / 2, (low.y + high.y) / 2}, peak.shown,
           peak.shown ? palette().text : palette().secondary);
  if (pressed) show_peak(tf, peak, !peak.shown);
  return pressed;
}

/// Solo, duplicate and remove.
bool action_cells(TransferFunction& tf, EditorState& editor, WidgetState& widgets,
                  std::span<const Peak> peaks, std::size_t row) {
  const Peak& peak = peaks[row];
  bool changed = false;
  if (small_button(widgets, fmt::format("peak{}.solo", row), "S", "Solo: this one alone, and back")) {
    show_only(tf, peaks, row);
    changed = true;
  }
  ImGui::SameLine(0, 0);
  if (small_button(widgets, fmt::format("peak{}.duplicate", row), "D",
                   "Duplicate: the same where there is most room; type where it is to be")) {
    const ValueRange range = tf.range();
    const double value = round_to_resolution(widest_gap(tf, range), 0.01 * range.width());
    editor.selection = duplicate_peak(tf, peak, value);
    editor.type_value = true;
    changed = true;
  }
  ImGui::SameLine(0, 0);
  if (small_button(widgets, fmt::format("peak{}.remove", row), "-", "Remove")) {
    erase_peak(tf, peak);
    editor.selection.clear();
    changed = true;
  }
  return changed;
}

void kind_cell(const Peak& peak) {
  ImGui::AlignTextToFramePadding();
  ImGui::TextDisabled("%s", !peak.detected ? "point" : peak.spike ? "spike" : "wide");
  tip(!peak.detected ? "Made a surface by hand"
      : peak.spike   ? "Narrow: as a surface, it is taken out of the volume rendering"
                     : "Its body stays in the volume rendering");
}

bool color_cell(TransferFunction& tf, const Peak& peak, std::size_t row, WidgetState& widgets) {
  glm::dvec3 color = tf.points[peak.first_point].color;
  if (!color_square(widgets, field_name(row, "color").c_str(), color)) return false;
  edit_above_curve(tf, [&] {
    for (const std::size_t i : top_of(peak)) tf.points[i].color = color;
  });
  return true;
}

/// The row as a whole: a click selects the peak, and the mouse over it lights its surface.
void select_cell(EditorState& editor, WidgetState& widgets, const Peak& peak, std::size_t row) {
  const bool selected = !editor.selection.empty() && editor.selection.front() >= peak.first_point &&
                        editor.selection.front() <= peak.last_point;
  ImGui::AlignTextToFramePadding();
  if (ImGui::Selectable(fmt::format("{}", row + 1).c_str(), selected,
                        ImGuiSelectableFlags_SpanAllColumns | ImGuiSelectableFlags_AllowItemOverlap,
                        {0, ImGui::GetFrameHeight()}))
    editor.selection = top_of(peak);
  const std::string name = fmt::format("peak{}", row);
  note_item(widgets, name);
  const auto& [low, high] = widgets.items[name];
  if (ImGui::IsWindowHovered() && ImGui::IsMouseHoveringRect(low, high, false)) editor.hovered_peak = row;
}

/// Whether the points of a peak are still there, which was found before the last edit.
bool is_there(const TransferFunction& tf, const Peak& peak) {
  return std::max(peak.right, peak.last_point) < tf.points.size();
}

bool peak_row(TransferFunction& tf, EditorState& editor, WidgetState& widgets, std::span<const Peak> peaks,
              std::size_t row) {
  const Peak& peak = peaks[row];
  ImGui::TableNextColumn();
  select_cell(editor, widgets, peak, row);
  bool changed = false;
  const auto cell = [&](const auto& draw) {
    ImGui::TableNextColumn();
    if (is_there(tf, peak)) changed |= draw();
  };
  cell([&] { return eye_cell(tf, peak, row, widgets); });
  cell([&] { return color_cell(tf, peak, row, widgets); });
  cell([&] { return value_cell(tf, editor, peak, row, widgets); });
  cell([&] { return opacity_cell(tf, peak, row, widgets); });
  cell([&] { return width_cell(tf, editor, peak, row, widgets); });
  cell([&] { return kind_cell(peak), false; });
  cell([&] { return action_cells(tf, editor, widgets, peaks, row); });
  return changed;
}

void columns() {
  const auto fixed = [](const char* name, float width) {
    ImGui::TableSetupColumn(name, ImGuiTableColumnFlags_WidthFixed, scaled(width));
  };
  ImGui::TableSetupScrollFreeze(0, 1);
  fixed("#", 18);
  fixed("##eye", 20);
  fixed("##color", 22);
  ImGui::TableSetupColumn("Value", ImGuiTableColumnFlags_WidthStretch, 1.2F);
  ImGui::TableSetupColumn("Opacity", ImGuiTableColumnFlags_WidthStretch, 0.9F);
  ImGui::TableSetupColumn("Width", ImGuiTableColumnFlags_WidthStretch, 1);
  fixed("Kind", 40);
  fixed("##actions", 56);
  ImGui::TableHeadersRow();
}

/// Of a volume of which points were left out: what a person must not take for the whole one's.
void thinned_note(StudioState& state, const StudioInputs& inputs) {
  if (!inputs.volume || !inputs.volume->part) return;
  const glm::u64vec3 stride = inputs.volume->part->stride;
  const std::uint64_t most = std::max({stride.x, stride.y, stride.z});
  if (most < 2) return;
  ImGui::TextDisabled("Of %s: thin surfaces have shrunk or are gone.",
                      short_part_text(*inputs.volume->part).c_str());
  note_item(state.widgets, "thinned note");
  if (ImGui::IsItemHovered())
    ImGui::SetTooltip("crest peaks PRESET --volume 'BOX OF THE WHOLE' --thinned %d\nmeasures by how much.",
                      int(std::min<std::uint64_t>(most, 1 << 20)));
}

}  // namespace

bool peaks_panel(Document& document, StudioState& state, const StudioInputs& inputs, float height) {
  TransferFunction& tf = document.preset.transfer_function;
  if (inputs.peaks.empty()) {
    ImGui::TextUnformatted("No peaks yet.");
    ImGui::PushTextWrapPos();
    ImGui::TextDisabled(
        "Add peak makes one at a value that you type; a click on a blue triangle under the "
        "curve makes one where the volume has a boundary. Any point can be made a surface: "
        "right-click it.");
    ImGui::PopTextWrapPos();
    return false;
  }
  thinned_note(state, inputs);
  constexpr ImGuiTableFlags flags =
      ImGuiTableFlags_ScrollY | ImGuiTableFlags_BordersInnerH | ImGuiTableFlags_PadOuterX;
  if (!ImGui::BeginTable("peaks", 8, flags, {0, height})) return false;
  columns();
  bool changed = false;
  std::vector<Peak> rows;
  std::ranges::copy_if(inputs.peaks, std::back_inserter(rows),
                       [&](const Peak& peak) { return is_there(tf, peak); });
  ImGuiListClipper clipper;
  clipper.Begin(int(rows.size()));
  // What is typed in a row is not lost when the row is scrolled away.
  if (!state.widgets.typed.empty()) clipper.ForceDisplayRangeByIndices(0, int(rows.size()));
  while (clipper.Step())
    for (int row = clipper.DisplayStart; row < clipper.DisplayEnd; ++row) {
      ImGui::TableNextRow();
      if (is_there(tf, rows[std::size_t(row)]))
        changed |= peak_row(tf, state.editor, state.widgets, rows, std::size_t(row));
    }
  ImGui::EndTable();
  return changed;
}

}  // namespace crest
