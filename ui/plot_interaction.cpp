#include "ui/plot_interaction.h"

#include <imgui_internal.h>

#include <algorithm>
#include <cmath>

#include "ui/arrange_points.h"
#include "ui/curve_beneath.h"
#include "ui/keys.h"
#include "ui/snap.h"
#include "ui/widgets.h"

namespace crest {
namespace {

constexpr double near_flank = 6;     // pixels: a peak whose flanks are nearer than this moves as a whole
constexpr float drag_threshold = 3;  // pixels, before a press becomes a drag
constexpr double wheel_factor = 1.3;
constexpr double snap_reach = 5;  // pixels

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
      EditorDrag{kind, ImGui::GetIO().MousePos, false, tf, editor.selection, plot.axis.visible, whole, 0, {}};
}

bool press_left(TransferFunction& tf, EditorState& editor, const Plot& plot, ValueRange whole) {
  const ImGuiIO& io = ImGui::GetIO();
  const bool twice = ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left);
  if (io.MousePos.y > plot.high.y + scaled(10)) {  // the strip of the value axis
    if (twice) editor.visible.reset();
    begin_drag(editor, EditorDrag::Kind::axis, tf, plot, whole);
    return false;
  }
  if (const auto handle = span_handle_at(plot, span_of(tf, editor.selection), io.MousePos)) {
    begin_drag(editor, *handle, tf, plot, whole);
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
    else if (!is_selected(editor.selection, *hit))
      editor.selection = {*hit};
    begin_drag(editor, EditorDrag::Kind::points, tf, plot, whole);
    editor.drag.grabbed = *hit;
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

/// Where `value` goes that is dragged, with all of `moving`: to what is near, or rounded to pixels.
double dragged_to(EditorState& editor, const Plot& plot, double value, const Selection& moving) {
  const double per_pixel = plot.axis.value_per_pixel();
  editor.drag.snapped.reset();
  if (editor.snap && !ImGui::GetIO().KeyAlt)
    editor.drag.snapped =
        snapped(value, snap_reach * per_pixel,
                snap_places(editor.drag.before.points, moving, editor.landmarks, plot.axis));
  return editor.drag.snapped.value_or(round_to_resolution(value, per_pixel));
}

Moved drag_across(EditorState& editor, const Plot& plot, double pixels) {
  const TransferFunction& before = editor.drag.before;
  const Selection& dragged = editor.drag.selected_before;
  const double per_pixel = plot.axis.value_per_pixel();
  const Selection moving = whole_of(before, dragged, near_flank * per_pixel);
  const std::size_t grabbed = editor.drag.grabbed;
  const std::size_t anchor = is_selected(dragged, grabbed) ? grabbed : dragged[0];
  const double to = dragged_to(editor, plot, before.points[anchor].value + pixels * per_pixel, moving);
  return moved(before, moving, anchor, to, editor.neighbours);
}

bool drag_points(TransferFunction& tf, EditorState& editor, const Plot& plot, ImVec2 shift) {
  const EditorDrag& drag = editor.drag;
  if (ImGui::GetIO().KeyShift) (std::abs(shift.x) >= std::abs(shift.y) ? shift.y : shift.x) = 0;
  const Selection& dragged = drag.selected_before;
  Moved result{drag.before.points, everything(drag.before)};
  if (shift.x != 0 && !dragged.empty()) result = drag_across(editor, plot, double(shift.x));
  editor.selection = result.of(dragged);
  TransferFunction after = drag.before, across = drag.before;
  after.points = across.points = result.points;
  if (shift.y != 0) {
    for (const std::size_t i : dragged) {
      const double opacity = plot.opacity_at(plot.y_of(drag.before.points[i].opacity) + shift.y);
      const double resolution =
          plot.opacity_axis.logarithmic ? 0.02 * opacity : 1.0 / double(plot.high.y - plot.low.y);
      after.points[result.now_at[i]].opacity = std::clamp(round_to_resolution(opacity, resolution), 0.0, 1.0);
    }
    keep_feet_on_curve(after, across);
  }
  if (after.points == tf.points) return false;
  tf.points = std::move(after.points);
  return true;
}

/// Window and level: the bar shifts the selected points, or all; its ends stretch them.
bool drag_span(TransferFunction& tf, EditorState& editor, const Plot& plot, double pixels) {
  const EditorDrag& drag = editor.drag;
  const Selection moving = selected_or_all(drag.before, drag.selected_before);
  const ValueRange from = values_of(drag.before, moving);
  const double shift = pixels * plot.axis.value_per_pixel();
  ValueRange to = from;
  if (drag.kind == EditorDrag::Kind::span_high) {
    to.max = std::max(dragged_to(editor, plot, from.max + shift, moving), from.min);
  } else {
    to.min = dragged_to(editor, plot, from.min + shift, moving);
    if (drag.kind == EditorDrag::Kind::span_low) to.min = std::min(to.min, from.max);
    if (drag.kind == EditorDrag::Kind::span) to.max = from.max + (to.min - from.min);
  }
  const Moved result = stretched(drag.before, moving, from, to);
  editor.selection = result.of(drag.selected_before);
  if (result.points == tf.points) return false;
  tf.points = result.points;
  return true;
}

void drag_box(const TransferFunction& tf, EditorState& editor, const Plot& plot) {
  const ImVec2 a = editor.drag.start, b = ImGui::GetIO().MousePos;
  editor.selection = ImGui::GetIO().KeyCtrl ? editor.drag.selected_before : Selection{};
  for (std::size_t i = 0; i < tf.points.size(); ++i) {
    const ImVec2 p = plot.place(tf.points[i]);
    const bool inside = p.x >= std::min(a.x, b.x) && p.x <= std::max(a.x, b.x) && p.y >= std::min(a.y, b.y) &&
                        p.y <= std::max(a.y, b.y);
    if (inside && !is_selected(editor.selection, i)) toggle(editor.selection, i);
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
    case EditorDrag::Kind::span:
    case EditorDrag::Kind::span_low:
    case EditorDrag::Kind::span_high:
      return drag_span(tf, editor, plot, double(shift.x));
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
      if (hit && !is_selected(editor.selection, *hit)) editor.selection = {*hit};
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
  const auto pressed = [](int key) { return int(ImGui::IsKeyPressed(key)); };
  const int across = pressed(key::right) - pressed(key::left), upward = pressed(key::up) - pressed(key::down);
  if (io.KeyCtrl) {
    if (across != 0) walk(editor.selection, tf.points.size(), across);
    return false;
  }
  if (editor.selection.empty() || (across == 0 && upward == 0)) return false;
  const float pixels = io.KeyShift ? 10 : io.KeyAlt ? 0.1F : 1;
  const double per_pixel = plot.axis.value_per_pixel();
  const std::vector<ControlPoint> before = tf.points;
  if (across != 0) {
    const std::size_t anchor = editor.selection[0];
    const double to =
        round_to_resolution(tf.points[anchor].value + double(pixels) * across * per_pixel, 0.1 * per_pixel);
    const Selection moving = whole_of(tf, editor.selection, near_flank * per_pixel);
    const Moved result = moved(tf, moving, anchor, to, editor.neighbours);
    tf.points = result.points;
    editor.selection = result.of(editor.selection);
  }
  if (upward != 0) {
    const TransferFunction across_only = tf;
    for (const std::size_t i : editor.selection) {
      const double unit = plot.opacity_axis.unit_of(tf.points[i].opacity);
      const double step = double(pixels) * upward / double(plot.high.y - plot.low.y);
      const double opacity = plot.opacity_axis.opacity_at(unit + step);
      tf.points[i].opacity = std::clamp(round_to_resolution(opacity, 1e-3 * opacity), 0.0, 1.0);
    }
    keep_feet_on_curve(tf, across_only);
  }
  return !(tf.points == before);
}

}  // namespace crest
