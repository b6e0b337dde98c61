#include "ui/editor_fields.h"

#include <algorithm>
#include <limits>

#include "ui/plot_interaction.h"
#include "ui/value_curves.h"

namespace crest {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double least_distance = 1e-300;

bool surface_choice(TransferFunction& tf, EditorState& editor, WidgetState& widgets, float width) {
  SurfaceMode mode = tf.points[editor.selection[0]].surface.mode;
  if (!choice(widgets, "##surface", mode, width)) return false;
  for (const std::size_t i : editor.selection) tf.points[i].surface.mode = mode;
  return true;
}

}  // namespace

bool editor_toolbar(TransferFunction& tf, EditorState& editor, WidgetState& widgets, ValueRange visible) {
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
  if (number_field(widgets, "##peak width", width, {0, infinity}, scaled(70))) editor.new_peak_width = width;
  tip("Width of a new peak, in values; 0 makes a true spike");
  ImGui::SameLine();
  value_curve_choice(editor, widgets);
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

bool unit_fields(TransferFunction& tf, WidgetState& widgets) {
  bool changed = false;
  field_label("Unit distance");
  changed |=
      number_field(widgets, "##unit distance", tf.unit_distance, {least_distance, infinity}, scaled(96));
  tip("An opacity is what this length of the material absorbs");
  ImGui::SameLine();
  changed |= choice(widgets, "##unit", tf.unit, scaled(104));
  return changed;
}

bool peak_rule_fields(TransferFunction& tf, WidgetState& widgets) {
  bool changed = false;
  const float field = scaled(80);
  field_label("Spike width");
  changed |= number_field(widgets, "##spike width", tf.spike_width, {0, 1}, field);
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

}  // namespace crest
