#include "ui/transfer_function_editor.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "ui/plot.h"
#include "ui/plot_interaction.h"
#include "ui/style.h"

namespace crest {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double tiny = 1e-300;

ValueRange volume_range(const Volume* volume) { return volume ? volume->statistics.range : ValueRange{0, 1}; }

bool add_peak(TransferFunction& tf, EditorState& editor, double value, double opacity, double width) {
  editor.selection = {insert_peak(tf, value, opacity, width, peak_color(tf.points.size() / 3))};
  return true;
}

bool surface_choice(TransferFunction& tf, EditorState& editor, WidgetState& widgets, float width) {
  SurfaceMode mode = tf.points[editor.selection[0]].surface.mode;
  if (!choice(widgets, "##surface", mode, width)) return false;
  for (const std::size_t i : editor.selection) tf.points[i].surface.mode = mode;
  return true;
}

/// Exact numbers of the selected point. It stands above the plot, so that a click into the plot first takes
/// what was typed.
bool point_fields(TransferFunction& tf, EditorState& editor, WidgetState& widgets) {
  if (editor.selection.empty()) {
    ImGui::AlignTextToFramePadding();
    ImGui::TextDisabled("%s", tf.points.empty() ? "Double-click to add a point"
                                                : "No point selected: click one, or drag a box");
    return false;
  }
  bool changed = false;
  const std::size_t first = editor.selection[0];
  ControlPoint& point = tf.points[first];
  ImGui::PushID(int(first));
  if (color_square(widgets, "##color", point.color)) {
    for (const std::size_t i : editor.selection) tf.points[i].color = point.color;
    changed = true;
  }
  ImGui::SameLine();
  const float spare = ImGui::GetContentRegionAvail().x;
  const float field = std::clamp((spare - scaled(250)) / 2, scaled(60), scaled(150));
  if (editor.selection.size() == 1) {
    field_label("Value");
    changed |=
        number_field(widgets, "##value", point.value, room_of(tf.points, first, editor.selection), field);
    ImGui::SameLine();
  } else {
    ImGui::AlignTextToFramePadding();
    ImGui::Text("%zu points", editor.selection.size());
    ImGui::SameLine();
  }
  field_label("Opacity");
  if (number_field(widgets, "##opacity", point.opacity, {0, 1}, field)) {
    for (const std::size_t i : editor.selection) tf.points[i].opacity = point.opacity;
    changed = true;
  }
  ImGui::SameLine();
  field_label("Surface");
  changed |= surface_choice(tf, editor, widgets, ImGui::GetContentRegionAvail().x);
  ImGui::PopID();
  return changed;
}

bool toolbar(TransferFunction& tf, EditorState& editor, WidgetState& widgets, ValueRange visible) {
  bool changed = false;
  if (ImGui::Button("Add peak")) {
    const double middle = widest_gap(tf, visible);
    changed |= add_peak(tf, editor, round_to_resolution(middle, 0.01 * visible.width()), 0.8,
                        new_peak_width(editor, visible));
  }
  note_item(widgets, "add peak");
  tip("Adds a spike where there is most room.\nThe right-click menu adds one under the mouse.");
  ImGui::SameLine();
  field_label("width");
  double width = new_peak_width(editor, visible);
  if (number_field(widgets, "##peak width", width, {0, infinity}, scaled(62))) editor.new_peak_width = width;
  tip("Width of a new peak, in values; 0 makes a true spike");
  ImGui::SameLine();
  static constexpr std::string_view scales[] = {"no histogram", "linear hist.", "log hist."};
  int scale = int(editor.histogram_scale);
  if (choice(widgets, "##histogram", scale, scales, scaled(104)))
    editor.histogram_scale = HistogramScale(scale);
  ImGui::SameLine();
  ImGui::Checkbox("log opacity", &editor.opacity_axis.logarithmic);
  note_item(widgets, "log opacity");
  tip("Opacities from 1e-6 to 1 by their logarithm");
  ImGui::SameLine();
  if (ImGui::Button("Fit")) editor.visible.reset();
  note_item(widgets, "fit");
  tip("Shows all values (also: double-click on the axis).\nWheel zooms about the mouse, Ctrl+wheel "
      "faster;\nmiddle drag or Shift+wheel pans; F shows the selected points");
  return changed;
}

bool point_menu(TransferFunction& tf, EditorState& editor, WidgetState& widgets) {
  bool changed = false;
  ControlPoint& point = tf.points[editor.selection[0]];
  static constexpr std::pair<const char*, SurfaceMode> modes[] = {{"Surface: auto", SurfaceMode::automatic},
                                                                  {"Surface: on", SurfaceMode::on},
                                                                  {"Surface: off", SurfaceMode::off}};
  for (const auto& [text, mode] : modes) {
    if (ImGui::MenuItem(text, nullptr, point.surface.mode == mode)) {
      for (const std::size_t i : editor.selection) tf.points[i].surface.mode = mode;
      changed = true;
    }
    note_item(widgets, text);
  }
  bool own = point.surface.opacity.has_value();
  if (ImGui::MenuItem("Surface opacity of its own", nullptr, own)) {
    for (const std::size_t i : editor.selection)
      tf.points[i].surface.opacity = own ? std::nullopt : std::optional(tf.points[i].opacity);
    changed = true;
  }
  if (point.surface.opacity)
    changed |= number_field(widgets, "##surface opacity", *point.surface.opacity, {0, 1}, scaled(120));
  ImGui::Separator();
  if (ImGui::MenuItem("Make step", nullptr, false, editor.selection.size() == 1)) {
    editor.selection = {make_step(tf, editor.selection[0])};
    changed = true;
  }
  note_item(widgets, "Make step");
  if (ImGui::MenuItem("Delete", "Del")) {
    erase_points(tf, editor.selection);
    editor.selection.clear();
    changed = true;
  }
  note_item(widgets, "Delete");
  return changed;
}

bool place_menu(TransferFunction& tf, EditorState& editor, WidgetState& widgets, ValueRange visible) {
  bool changed = false;
  if (ImGui::MenuItem("Add point", "double-click")) {
    editor.selection = {insert_point(tf, editor.menu_value, editor.menu_opacity)};
    changed = true;
  }
  note_item(widgets, "Add point");
  if (ImGui::MenuItem("Add peak"))
    changed |= add_peak(tf, editor, editor.menu_value, editor.menu_opacity, new_peak_width(editor, visible));
  note_item(widgets, "Add peak");
  if (ImGui::MenuItem("Add step")) {
    editor.selection = {insert_step(tf, editor.menu_value, editor.menu_opacity)};
    changed = true;
  }
  note_item(widgets, "Add step");
  return changed;
}

bool popups(Document& document, EditorState& editor, WidgetState& widgets, const StudioInputs& inputs,
            ValueRange visible) {
  TransferFunction& tf = document.preset.transfer_function;
  bool changed = false;
  if (ImGui::BeginPopup("plot menu")) {
    changed |=
        editor.selection.empty() ? place_menu(tf, editor, widgets, visible) : point_menu(tf, editor, widgets);
    ImGui::Separator();
    if (!editor.selection.empty() && ImGui::MenuItem("Zoom to selection", "F"))
      frame_selection(document, editor, inputs);
    if (ImGui::MenuItem("Show all values")) editor.visible.reset();
    ImGui::EndPopup();
  }
  if (ImGui::BeginPopup("point color")) {
    if (!editor.selection.empty() && color_picker("##picker", tf.points[editor.selection[0]].color)) {
      for (const std::size_t i : editor.selection) tf.points[i].color = tf.points[editor.selection[0]].color;
      changed = true;
    }
    ImGui::EndPopup();
  }
  return changed;
}

/// What one opacity means: the distance that absorbs it.
bool unit_fields(TransferFunction& tf, WidgetState& widgets) {
  bool changed = false;
  field_label("Unit distance");
  changed |= number_field(widgets, "##unit distance", tf.unit_distance, {tiny, infinity}, scaled(96));
  tip("An opacity is what this length of the material absorbs");
  ImGui::SameLine();
  changed |= choice(widgets, "##unit", tf.unit, scaled(104));
  return changed;
}

bool peak_rule_fields(TransferFunction& tf, WidgetState& widgets) {
  bool changed = false;
  const float field = scaled(80);
  field_label("Spike width");
  changed |= number_field(widgets, "##spike width", tf.spike_width, {0, infinity}, field);
  tip("A peak no wider than this share of the TF's span is a spike:\nshown as a surface, it is taken out of "
      "the volume rendering");
  ImGui::SameLine();
  field_label("Least prominence");
  changed |= number_field(widgets, "##min prominence", tf.min_prominence, {0, 1}, field);
  tip("Peaks that rise less above the valleys beside them are not peaks");
  ImGui::SameLine();
  field_label("Plateau");
  changed |= number_field(widgets, "##plateau width", tf.plateau_width, {0, infinity},
                          ImGui::GetContentRegionAvail().x);
  tip("A flat top narrower than this is one peak");
  return changed;
}

LinearMap data_to_domain(const TransferFunction& tf, ValueRange data) {
  if (tf.domain == Domain::data) return {};
  const double width = data.width() > 0 ? data.width() : 1;
  return {-data.min / width, 1 / width};
}

ValueRange in_data(LinearMap to_domain, ValueRange visible) {
  return {(visible.min - to_domain.offset) / to_domain.scale,
          (visible.max - to_domain.offset) / to_domain.scale};
}

Plot make_plot(const EditorState& editor, ImVec2 corner, ImVec2 size, ValueRange visible) {
  Plot plot;
  const float gutter = scaled(42), strip = axis_ticks(visible, 8).offset.empty() ? scaled(28) : scaled(44);
  plot.low = {corner.x + gutter, corner.y + scaled(6)};
  plot.high = {std::max(plot.low.x + 8, corner.x + size.x - scaled(8)),
               std::max(plot.low.y + 8, corner.y + size.y - strip)};
  plot.axis = {visible, double(plot.low.x), double(plot.high.x - plot.low.x)};
  plot.opacity_axis = editor.opacity_axis;
  return plot;
}

void draw_plot(const TransferFunction& tf, EditorState& editor, const Plot& plot,
               const StudioInputs& inputs) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  draw_axes(list, plot);
  list.PushClipRect(plot.low, plot.high, true);
  if (inputs.volume && editor.histogram_scale != HistogramScale::off) {
    const LinearMap to_domain = data_to_domain(tf, inputs.volume->statistics.range);
    update_histogram(editor.histogram, *inputs.volume, in_data(to_domain, plot.axis.visible));
    draw_histogram(list, plot, editor.histogram, editor.histogram_scale, to_domain);
  }
  draw_curve(list, plot, tf);
  draw_peaks(list, plot, tf, inputs.peaks);
  list.PopClipRect();
  list.AddRect(plot.low, plot.high, palette::frame);
  const float margin = scaled(8);
  list.PushClipRect({plot.low.x - margin, plot.low.y - margin}, {plot.high.x + margin, plot.high.y + margin},
                    true);
  const bool free = ImGui::IsItemHovered() && editor.drag.kind == EditorDrag::Kind::none;
  draw_points(list, plot, tf, editor.selection,
              free ? point_near(plot, tf.points, ImGui::GetIO().MousePos) : std::nullopt);
  if (editor.drag.kind == EditorDrag::Kind::box && editor.drag.under_way)
    list.AddRect(editor.drag.start, ImGui::GetIO().MousePos, palette::accent);
  list.PopClipRect();
}

std::string place_text(const TransferFunction& tf, const Plot& plot) {
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const double value = round_to_resolution(plot.axis.value_at(mouse.x), plot.axis.value_per_pixel());
  return fmt::format("value {}   curve {:.3g}   cursor {:.3g}", exact_text(value),
                     evaluate(tf, value).opacity, plot.opacity_at(mouse.y));
}

}  // namespace

ValueRange axis_range(const TransferFunction& tf, const Volume* volume) {
  const ValueRange range = range_in_domain(tf, volume_range(volume));
  if (tf.points.empty()) return whole_range(range, range);
  const ValueRange span = tf.span();
  return whole_range(volume || tf.domain == Domain::normalized ? range : span, span);
}

void frame_selection(const Document& document, EditorState& editor, const StudioInputs& inputs) {
  const TransferFunction& tf = document.preset.transfer_function;
  if (editor.selection.empty()) return editor.visible.reset();
  // One point alone has no width: its neighbours give it one.
  std::size_t first = editor.selection.front(), last = editor.selection.back();
  if (last >= tf.points.size()) return;
  if (tf.points[first].value == tf.points[last].value) {
    first -= std::min<std::size_t>(first, 1);
    last = std::min(last + 1, tf.points.size() - 1);
  }
  const ValueRange whole = axis_range(tf, inputs.volume);
  const double low = tf.points[first].value, high = tf.points[last].value;
  const double middle = (low + high) / 2;
  const double width = std::max((high - low) * 1.6, whole.width() * deepest_zoom);
  editor.visible = pan(zoom({middle - width / 2, middle + width / 2}, whole, middle, 1), whole, 0);
}

bool transfer_function_editor(Document& document, StudioState& state, const StudioInputs& inputs) {
  TransferFunction& tf = document.preset.transfer_function;
  EditorState& editor = state.editor;
  std::erase_if(editor.selection, [&](std::size_t i) { return i >= tf.points.size(); });
  const bool dragging = editor.drag.kind == EditorDrag::Kind::points;
  // The axis holds still while points are dragged beyond its ends.
  const ValueRange whole = dragging ? editor.drag.whole : axis_range(tf, inputs.volume);
  if (editor.visible && !dragging) editor.visible = pan(*editor.visible, whole, 0);
  const ValueRange visible = dragging ? editor.drag.visible : editor.visible.value_or(whole);

  bool changed = toolbar(tf, editor, state.widgets, visible);
  changed |= point_fields(tf, editor, state.widgets);
  const float below = ImGui::GetFrameHeightWithSpacing() * (editor.peak_rule ? 2.0F : 1.0F);
  const ImVec2 corner = ImGui::GetCursorScreenPos(), room = ImGui::GetContentRegionAvail();
  const ImVec2 size{std::max(room.x, scaled(100)), std::max(room.y - below, scaled(90))};
  ImGui::InvisibleButton("##plot", size,
                         ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight |
                             ImGuiButtonFlags_MouseButtonMiddle);
  Plot plot = make_plot(editor, corner, size, visible);
  state.widgets.items["plot"] = {plot.low, plot.high};
  for (std::size_t i = 0; i < tf.points.size(); ++i) {
    const ImVec2 at = plot.place(tf.points[i]);
    state.widgets.items[fmt::format("point/{}", i)] = {at, at};
  }
  changed |= handle_plot_mouse(tf, editor, plot, whole);
  if (ImGui::IsItemHovered()) state.under_cursor = place_text(tf, plot);
  const bool keys_are_free = !ImGui::GetIO().WantTextInput && !ImGui::IsAnyItemActive() &&
                             !ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup);
  if (keys_are_free) {
    changed |= handle_plot_keys(tf, editor, plot);
    if (ImGui::IsKeyPressed('F', false) && !ImGui::GetIO().KeyCtrl) frame_selection(document, editor, inputs);
  }
  draw_plot(tf, editor, plot, inputs);
  changed |= popups(document, editor, state.widgets, inputs, visible);
  changed |= unit_fields(tf, state.widgets);
  ImGui::SameLine();
  if (ImGui::ArrowButton("##peak rule", editor.peak_rule ? ImGuiDir_Down : ImGuiDir_Right))
    editor.peak_rule = !editor.peak_rule;
  note_item(state.widgets, "peak rule");
  ImGui::SameLine(0, ImGui::GetStyle().ItemInnerSpacing.x);
  ImGui::TextDisabled("peak rule");
  if (editor.peak_rule) changed |= peak_rule_fields(tf, state.widgets);
  return changed;
}

}  // namespace crest
