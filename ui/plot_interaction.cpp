#include "ui/plot_interaction.h"

#include <imgui_internal.h>

#include <algorithm>
#include <cmath>

#include "ui/keys.h"
#include "ui/widgets.h"

namespace crest {
namespace {

constexpr double near_flank = 6;     // pixels: a peak whose flanks are nearer than this moves as a whole
constexpr float drag_threshold = 3;  // pixels, before a press becomes a drag
constexpr double wheel_factor = 1.3;
constexpr double share_of_view = 0.02;  // width of a new peak

bool is_selected(const EditorState& editor, std::size_t i) {
  return std::binary_search(editor.selection.begin(), editor.selection.end(), i);
}

void toggle(Selection& selection, std::size_t i) {
  const auto place = std::lower_bound(selection.begin(), selection.end(), i);
  if (place != selection.end() && *place == i)
    selection.erase(place);
  else
    selection.insert(place, i);
}

void begin_drag(EditorState& editor, EditorDrag::Kind kind, const TransferFunction& tf, const Plot& plot,
                ValueRange whole) {
  editor.drag =
      EditorDrag{kind, ImGui::GetIO().MousePos, false, tf, editor.selection, plot.axis.visible, whole};
}

bool press_left(TransferFunction& tf, EditorState& editor, const Plot& plot, ValueRange whole) {
  const ImGuiIO& io = ImGui::GetIO();
  const bool twice = ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left);
  if (io.MousePos.y > plot.high.y + scaled(10)) {  // the strip of the value axis
    if (twice) editor.visible.reset();
    begin_drag(editor, EditorDrag::Kind::axis, tf, plot, whole);
    return false;
  }
  const auto hit = point_near(plot, tf.points, io.MousePos);
  if (hit && twice) {
    ImGui::OpenPopup("point color");
    return false;
  }
  if (hit) {
    if (io.KeyCtrl)
      toggle(editor.selection, *hit);
    else if (!is_selected(editor, *hit))
      editor.selection = {*hit};
    begin_drag(editor, EditorDrag::Kind::points, tf, plot, whole);
    return false;
  }
  if (twice) {
    const double value = round_to_resolution(plot.axis.value_at(io.MousePos.x), plot.axis.value_per_pixel());
    const double opacity =
        round_to_resolution(plot.opacity_at(io.MousePos.y), 1e-2 * plot.opacity_at(io.MousePos.y));
    editor.selection = {insert_point(tf, value, opacity)};
    begin_drag(editor, EditorDrag::Kind::points, tf, plot, whole);
    return true;
  }
  begin_drag(editor, EditorDrag::Kind::box, tf, plot, whole);
  return false;
}

/// Of points that lie on one another, the one that can go the way of the drag.
void choose_among_coincident(EditorState& editor, const Plot& plot, float dx) {
  if (editor.selection.size() != 1 || dx == 0) return;
  const auto& points = editor.drag.before.points;
  const ControlPoint& taken = points[editor.selection[0]];
  std::size_t chosen = editor.selection[0];
  for (std::size_t i = 0; i < points.size(); ++i) {
    const bool coincides =
        points[i].value == taken.value && std::abs(plot.place(points[i]).y - plot.place(taken).y) < 2;
    if (coincides && (dx < 0 ? i < chosen : i > chosen)) chosen = i;
  }
  editor.selection = editor.drag.selected_before = {chosen};
}

/// The selected points of `before` go `shift` along the axis, rounded to `resolution`.
Moved shifted(const TransferFunction& before, const Selection& selection, double shift, double resolution,
              double per_pixel, Neighbours neighbours) {
  const std::size_t anchor = selection[selection.size() / 2];
  const double to = round_to_resolution(before.points[anchor].value + shift, resolution);
  return moved(before, whole_of(before, selection, near_flank * per_pixel), anchor, to, neighbours);
}

bool drag_points(TransferFunction& tf, EditorState& editor, const Plot& plot, ImVec2 shift) {
  const EditorDrag& drag = editor.drag;
  if (ImGui::GetIO().KeyShift) (std::abs(shift.x) >= std::abs(shift.y) ? shift.y : shift.x) = 0;
  const double per_pixel = plot.axis.value_per_pixel();
  const Selection& dragged = drag.selected_before;
  Moved result{drag.before.points, {}};
  editor.selection = dragged;
  if (shift.x != 0 && !dragged.empty()) {
    result =
        shifted(drag.before, dragged, double(shift.x) * per_pixel, per_pixel, per_pixel, editor.neighbours);
    editor.selection = result.of(dragged);
  }
  if (shift.y != 0)
    for (const std::size_t i : dragged) {
      const double opacity = plot.opacity_at(plot.y_of(drag.before.points[i].opacity) + shift.y);
      const double resolution =
          plot.opacity_axis.logarithmic ? 0.02 * opacity : 1.0 / double(plot.high.y - plot.low.y);
      result.points[shift.x != 0 ? result.now_at[i] : i].opacity =
          std::clamp(round_to_resolution(opacity, resolution), 0.0, 1.0);
    }
  if (result.points == tf.points) return false;
  tf.points = std::move(result.points);
  return true;
}

void drag_box(const TransferFunction& tf, EditorState& editor, const Plot& plot) {
  const ImVec2 a = editor.drag.start, b = ImGui::GetIO().MousePos;
  editor.selection = ImGui::GetIO().KeyCtrl ? editor.drag.selected_before : Selection{};
  for (std::size_t i = 0; i < tf.points.size(); ++i) {
    const ImVec2 p = plot.place(tf.points[i]);
    const bool inside = p.x >= std::min(a.x, b.x) && p.x <= std::max(a.x, b.x) && p.y >= std::min(a.y, b.y) &&
                        p.y <= std::max(a.y, b.y);
    if (inside && !is_selected(editor, i)) toggle(editor.selection, i);
  }
}

bool continue_drag(TransferFunction& tf, EditorState& editor, const Plot& plot, ValueRange whole) {
  EditorDrag& drag = editor.drag;
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const ImVec2 shift{mouse.x - drag.start.x, mouse.y - drag.start.y};
  if (!drag.under_way) {
    if (std::max(std::abs(shift.x), std::abs(shift.y)) < drag_threshold) return false;
    drag.under_way = true;
    if (drag.kind == EditorDrag::Kind::points) choose_among_coincident(editor, plot, shift.x);
  }
  switch (drag.kind) {
    case EditorDrag::Kind::points:
      return drag_points(tf, editor, plot, shift);
    case EditorDrag::Kind::axis:
      editor.visible = pan(drag.visible, whole, -double(shift.x) * plot.axis.value_per_pixel());
      return false;
    case EditorDrag::Kind::box:
      drag_box(tf, editor, plot);
      return false;
    case EditorDrag::Kind::none:
      break;
  }
  return false;
}

void handle_wheel(EditorState& editor, const Plot& plot, ValueRange whole) {
  const ImGuiIO& io = ImGui::GetIO();
  const double sideways = double(io.KeyShift ? io.MouseWheel : io.MouseWheelH);
  if (sideways != 0)
    editor.visible = pan(plot.axis.visible, whole, -sideways * 0.1 * plot.axis.visible.width());
  else if (io.MouseWheel != 0) {
    const double steps = double(io.MouseWheel) * (io.KeyCtrl ? 5 : 1);
    editor.visible =
        zoom(plot.axis.visible, whole, plot.axis.value_at(io.MousePos.x), std::pow(wheel_factor, -steps));
  }
  if (editor.visible == whole) editor.visible.reset();
}

/// Selects the point next to the selected one.
void walk(Selection& selection, std::size_t count, int direction) {
  if (count == 0) return;
  if (selection.empty())
    selection = {direction > 0 ? 0 : count - 1};
  else if (direction > 0)
    selection = {std::min(selection.back() + 1, count - 1)};
  else
    selection = {selection.front() - std::min<std::size_t>(selection.front(), 1)};
}

}  // namespace

double new_peak_width(const TransferFunction& tf, const EditorState& editor, ValueRange visible) {
  const double width = share_of_view * visible.width(), limit = widest_spike(tf);
  return editor.new_peak_width.value_or(std::min(round_to_resolution(width, 0.1 * width), limit));
}

bool add_peak(TransferFunction& tf, EditorState& editor, double value, double opacity, double width) {
  editor.selection = {insert_peak(tf, value, opacity, width, peak_color(tf.points.size() / 3))};
  editor.type_value = true;
  return true;
}

bool handle_plot_mouse(TransferFunction& tf, EditorState& editor, const Plot& plot, ValueRange whole) {
  bool changed = false;
  const bool hovered = ImGui::IsItemHovered();
  if (hovered) {
    ImGui::SetItemUsingMouseWheel();
    handle_wheel(editor, plot, whole);
    if (ImGui::IsMouseClicked(ImGuiMouseButton_Left)) changed |= press_left(tf, editor, plot, whole);
    if (ImGui::IsMouseClicked(ImGuiMouseButton_Middle))
      begin_drag(editor, EditorDrag::Kind::axis, tf, plot, whole);
    if (ImGui::IsMouseClicked(ImGuiMouseButton_Right)) {
      const ImVec2 mouse = ImGui::GetIO().MousePos;
      const auto hit = point_near(plot, tf.points, mouse);
      if (hit && !is_selected(editor, *hit)) editor.selection = {*hit};
      if (!hit) editor.selection.clear();
      editor.menu_value = round_to_resolution(plot.axis.value_at(mouse.x), plot.axis.value_per_pixel());
      editor.menu_opacity = round_to_resolution(plot.opacity_at(mouse.y), 0.02 * plot.opacity_at(mouse.y));
      ImGui::OpenPopup("plot menu");
    }
  }
  if (editor.drag.kind == EditorDrag::Kind::none) return changed;
  if (ImGui::IsItemActive()) return continue_drag(tf, editor, plot, whole) || changed;
  const bool clicked_empty = editor.drag.kind == EditorDrag::Kind::box && !editor.drag.under_way;
  if (clicked_empty && !ImGui::GetIO().KeyCtrl) editor.selection.clear();
  editor.drag = {};
  return changed;
}

bool handle_plot_keys(TransferFunction& tf, EditorState& editor, const Plot& plot) {
  const ImGuiIO& io = ImGui::GetIO();
  const auto pressed = [](ImGuiKey key) { return ImGui::IsKeyPressed(ImGui::GetKeyIndex(key)); };
  if (io.KeyCtrl && pressed(ImGuiKey_A)) {
    editor.selection.clear();
    for (std::size_t i = 0; i < tf.points.size(); ++i) editor.selection.push_back(i);
  }
  const int across = int(pressed(ImGuiKey_RightArrow)) - int(pressed(ImGuiKey_LeftArrow));
  const int upward = int(pressed(ImGuiKey_UpArrow)) - int(pressed(ImGuiKey_DownArrow));
  if (io.KeyCtrl) {
    if (across != 0) walk(editor.selection, tf.points.size(), across);
    return false;
  }
  if (editor.selection.empty()) return false;
  if (pressed(ImGuiKey_Escape)) editor.selection.clear();
  if (pressed(ImGuiKey_Delete) || pressed(ImGuiKey_Backspace)) {
    erase_points(tf, editor.selection);
    editor.selection.clear();
    return true;
  }
  if (across == 0 && upward == 0) return false;
  const float pixels = io.KeyShift ? 10 : io.KeyAlt ? 0.1F : 1;
  const double per_pixel = plot.axis.value_per_pixel();
  const std::vector<ControlPoint> before = tf.points;
  if (across != 0) {
    const Moved result = shifted(tf, editor.selection, double(pixels) * across * per_pixel, 0.1 * per_pixel,
                                 per_pixel, editor.neighbours);
    tf.points = result.points;
    editor.selection = result.of(editor.selection);
  }
  if (upward != 0)
    for (const std::size_t i : editor.selection) {
      const double unit = plot.opacity_axis.unit_of(tf.points[i].opacity);
      const double step = double(pixels) * upward / double(plot.high.y - plot.low.y);
      const double opacity = plot.opacity_axis.opacity_at(unit + step);
      tf.points[i].opacity = std::clamp(round_to_resolution(opacity, 1e-3 * opacity), 0.0, 1.0);
    }
  return !(tf.points == before);
}

}  // namespace crest
