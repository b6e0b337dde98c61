#include "ui/editor_fields.h"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

#include "ui/actions.h"
#include "ui/curve_beneath.h"
#include "ui/number_field.h"
#include "ui/point_tools.h"
#include "ui/value_curves.h"

namespace crest {
namespace {

/// The least width of a field for which its row has room, and of the rest of the row.
constexpr float least_field = 60, rest_of_row = 250;
constexpr float least_labelled = 500;  ///< of the toolbar's width, for a label in it

std::vector<double> of_selected(const TransferFunction& tf, const Selection& selection,
                                double ControlPoint::*field) {
  std::vector<double> values;
  for (const std::size_t i : selection) values.push_back(tf.points[i].*field);
  return values;
}

std::string stopped(double to, ValueRange room) {
  if (to >= room.min && to <= room.max) return {};
  return fmt::format("A neighbour stops it at {} (Points > Stop at their neighbours)",
                     exact_text(std::clamp(to, room.min, room.max)));
}

/// The point for which a typed value is meant: the top of what is selected, or the first point.
std::size_t anchor_of(const TransferFunction& tf, const Selection& selection) {
  const auto higher = [&](std::size_t a, std::size_t b) {
    return tf.points[a].opacity < tf.points[b].opacity;
  };
  const std::size_t top = *std::ranges::max_element(selection, higher);
  const auto as_high = std::ranges::count_if(
      selection, [&](std::size_t i) { return tf.points[i].opacity == tf.points[top].opacity; });
  return as_high == 1 && top != selection.back() ? top : selection[0];
}

/// What is typed moves the anchor, and all that goes with the selection by the same difference.
bool value_field(TransferFunction& tf, EditorState& editor, WidgetState& widgets, float width) {
  const Selection moving = whole_of(tf, editor.selection);
  const std::size_t anchor = anchor_of(tf, editor.selection);
  const double value = tf.points[anchor].value;
  const std::vector<double> values = of_selected(tf, editor.selection, &ControlPoint::value);
  const auto why_not = [&](const NumberEdit& edit) {
    const double to = edit(value);
    if (const std::string why = why_outside(to, any_value); !why.empty())
      return fmt::format("{} {}", exact_text(to), why);
    return editor.neighbours == Neighbours::stop ? stopped(to, room_of(tf.points, moving, anchor))
                                                 : std::string();
  };
  field_label(values.size() == 1 ? "Value" : anchor == editor.selection[0] ? "First" : "Top");
  if (std::exchange(editor.type_value, false)) open_next_field(widgets, "##value");
  const auto edit = number_entry(widgets, "##value", numbers_text(values, width), why_not, width);
  tip(values.size() > 1
          ? "Of the top of the selected points, or of the first; the others go along.\n+=5 moves them all by "
            "5"
          : "A peak, spike or step moves as a whole. +=5 moves it by 5;\nthe menu Points says what happens "
            "to "
            "those in its way");
  if (!edit) return false;
  const Moved result = moved(tf, moving, anchor, (*edit)(value), editor.neighbours);
  editor.selection = result.of(editor.selection);
  tf.points = result.points;
  return true;
}

bool opacity_field(TransferFunction& tf, const EditorState& editor, WidgetState& widgets, float width) {
  const auto edit = numbers_field(
      widgets, "##opacity", of_selected(tf, editor.selection, &ControlPoint::opacity), unit_interval, width);
  tip("Of all selected points; *=0.5 halves each, +=0.1 adds to each");
  if (!edit) return false;
  const TransferFunction before = tf;
  for (const std::size_t i : editor.selection) tf.points[i].opacity = (*edit)(tf.points[i].opacity);
  keep_feet_on_curve(tf, before);
  return true;
}

/// One square for all selected points: of two colours where theirs differ.
bool color_field(TransferFunction& tf, const EditorState& editor, WidgetState& widgets) {
  const ControlPoint& first = tf.points[editor.selection[0]];
  const auto other = std::ranges::find_if(editor.selection,
                                          [&](std::size_t i) { return tf.points[i].color != first.color; });
  glm::dvec3 color = first.color;
  const bool changed = color_square(widgets, "##color", color);
  if (changed) {
    const TransferFunction before = tf;
    for (const std::size_t i : editor.selection) tf.points[i].color = color;
    keep_feet_on_curve(tf, before);
  } else if (other != editor.selection.end()) {
    const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
    ImGui::GetWindowDrawList()->AddTriangleFilled({high.x - 1, low.y + 1}, {high.x - 1, high.y - 1},
                                                  {low.x + 1, high.y - 1}, packed(tf.points[*other].color));
    tip("The points have several colours; one that is chosen here goes to all");
  }
  return changed;
}

bool surface_choice(TransferFunction& tf, const EditorState& editor, WidgetState& widgets, float width) {
  static constexpr std::string_view names[] = {"auto", "on", "off"};
  const auto mode_of = [&](std::size_t i) { return int(tf.points[i].surface.mode); };
  int mode = mode_of(editor.selection[0]);
  for (const std::size_t i : editor.selection)
    if (mode_of(i) != mode) mode = -1;
  if (!choice(widgets, "##surface", mode, names, width)) return false;
  for (const std::size_t i : editor.selection) tf.points[i].surface.mode = SurfaceMode(mode);
  return true;
}

}  // namespace

bool editor_toolbar(TransferFunction& tf, EditorState& editor, WidgetState& widgets, ValueRange volume,
                    ValueRange visible) {
  bool changed = false;
  const auto opens_menu = [&](const char* text, const char* popup) {
    ImGui::SameLine();
    if (ImGui::Button(text)) ImGui::OpenPopup(popup);
    note_item(widgets, popup);
    ImGui::SetNextWindowPos({ImGui::GetItemRectMin().x, ImGui::GetItemRectMax().y + scaled(2)});
    if (!ImGui::BeginPopup(popup)) return false;
    return true;
  };
  if (ImGui::Button("Add peak")) changed |= add_shape(tf, editor, Shape::spike, visible);
  note_item(widgets, "add peak");
  tip(fmt::format("Adds a spike where there is most room; type where it is to be (also: {}).\n"
                  "The right-click menu adds one under the mouse.",
                  key_text_of(adding(Shape::spike)))
          .c_str());
  const bool is_roomy = ImGui::GetWindowContentRegionMax().x > scaled(least_labelled);
  ImGui::SameLine();
  if (is_roomy) field_label("width");
  double width = new_width(tf, editor, Shape::spike, visible);
  if (number_field(widgets, "##peak width", width, not_negative, scaled(66))) editor.new_peak_width = width;
  tip("Width of what is added, in values; 0 makes a true spike");
  if (opens_menu("Shapes", "shapes")) {
    changed |= shapes_menu(tf, editor, widgets, visible);
    ImGui::EndPopup();
  }
  if (opens_menu("Points", "points")) {
    changed |= points_menu(tf, editor, widgets, volume, visible);
    ImGui::EndPopup();
  }
  ImGui::SameLine();
  const float rest = ImGui::CalcTextSize("logFit").x + ImGui::GetFrameHeight() +
                     3 * ImGui::GetStyle().ItemSpacing.x + 2 * ImGui::GetStyle().FramePadding.x;
  value_curve_choice(editor, widgets, ImGui::GetContentRegionAvail().x - rest);
  ImGui::SameLine();
  ImGui::Checkbox("log", &editor.opacity_axis.logarithmic);
  note_item(widgets, "log opacity");
  tip("Opacities from 1e-6 to 1 by their logarithm");
  ImGui::SameLine();
  if (ImGui::Button("Fit")) editor.visible.reset();
  note_item(widgets, "fit");
  tip(fmt::format("Shows all values (also: double-click on the axis).\nWheel zooms about the mouse, "
                  "Ctrl+wheel faster;\nmiddle drag or Shift+wheel pans; {} shows the selected points",
                  key_text_of("Zoom to the selected points"))
          .c_str());
  return changed;
}

bool point_fields(TransferFunction& tf, EditorState& editor, WidgetState& widgets) {
  if (editor.selection.empty()) {
    ImGui::AlignTextToFramePadding();
    ImGui::TextDisabled("%s", tf.points.empty() ? "Double-click to add a point"
                                                : "No point selected: click one, or drag a box");
    return false;
  }
  const bool several = editor.selection.size() > 1;
  ImGui::PushID(int(editor.selection[0]));
  bool changed = color_field(tf, editor, widgets);
  ImGui::SameLine();
  if (several) {
    ImGui::AlignTextToFramePadding();
    ImGui::Text("%zu points", editor.selection.size());
    ImGui::SameLine();
  }
  const float spare = ImGui::GetContentRegionAvail().x;
  const float field = std::clamp((spare - scaled(rest_of_row)) / 2, scaled(least_field), scaled(150));
  changed |= value_field(tf, editor, widgets, field);
  ImGui::SameLine();
  field_label("Opacity");
  changed |= opacity_field(tf, editor, widgets, field);
  ImGui::SameLine();
  field_label("Surface");
  changed |= surface_choice(tf, editor, widgets, ImGui::GetContentRegionAvail().x);
  ImGui::PopID();
  return changed;
}

bool unit_fields(TransferFunction& tf, WidgetState& widgets) {
  bool changed = false;
  field_label("Unit distance");
  changed |= number_field(widgets, "##unit distance", tf.unit_distance, positive, scaled(96));
  tip("An opacity is what this length of the material absorbs");
  ImGui::SameLine();
  changed |= choice(widgets, "##unit", tf.unit, scaled(104));
  return changed;
}

bool peak_rule_fields(TransferFunction& tf, WidgetState& widgets) {
  bool changed = false;
  const float field = scaled(80);
  field_label("Spike width");
  changed |= number_field(widgets, "##spike width", tf.spike_width, unit_interval, field);
  tip("A peak no wider than this share of the TF's span is a spike:\nshown as a surface, it is taken out of "
      "the volume rendering");
  ImGui::SameLine();
  field_label("Least prominence");
  changed |= number_field(widgets, "##min prominence", tf.min_prominence, unit_interval, field);
  tip("Peaks that rise less above the valleys beside them are not peaks");
  ImGui::SameLine();
  field_label("Plateau");
  changed |= number_field(widgets, "##plateau width", tf.plateau_width, not_negative,
                          ImGui::GetContentRegionAvail().x);
  tip("A flat top narrower than this is one peak");
  return changed;
}

}  // namespace crest
