#include "ui/plot_menu.h"

#include <utility>

#include "ui/actions.h"
#include "ui/clipboard.h"
#include "ui/number_field.h"
#include "ui/point_tools.h"
#include "ui/transfer_function_editor.h"

namespace crest {
namespace {

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
    changed |= number_field(widgets, "##surface opacity", *point.surface.opacity, unit_interval, scaled(120));
  ImGui::Separator();
  if (ImGui::MenuItem("Make step", nullptr, false, editor.selection.size() == 1)) {
    editor.selection = {make_step(tf, editor.selection[0])};
    changed = true;
  }
  note_item(widgets, "Make step");
  if (ImGui::MenuItem("Delete", key_text_of("Delete").c_str())) changed |= delete_points(tf, editor);
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
  for (const auto& [text, shape] : {std::pair{"Add peak", Shape::spike},
                                    {"Add tent", Shape::tent},
                                    {"Add box", Shape::box},
                                    {"Add Gaussian", Shape::gaussian},
                                    {"Add ramp", Shape::ramp},
                                    {"Add step", Shape::step}}) {
    if (ImGui::MenuItem(text))
      changed |= add_shape(tf, editor, shape, editor.menu_value, editor.menu_opacity, visible);
    note_item(widgets, text);
  }
  return changed;
}

}  // namespace

bool plot_menus(Document& document, EditorState& editor, WidgetState& widgets, const StudioInputs& inputs,
                ValueRange visible) {
  TransferFunction& tf = document.preset.transfer_function;
  bool changed = false;
  if (ImGui::BeginPopup("plot menu")) {
    changed |=
        editor.selection.empty() ? place_menu(tf, editor, widgets, visible) : point_menu(tf, editor, widgets);
    ImGui::Separator();
    if (ImGui::BeginMenu("Points")) {
      const ValueRange volume = inputs.volume ? inputs.volume->statistics.range : ValueRange{};
      changed |= points_menu(tf, editor, widgets, volume, visible);
      ImGui::EndMenu();
    }
    if (!editor.selection.empty() &&
        ImGui::MenuItem("Zoom to selection", key_text_of("Zoom to the selected points").c_str()))
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

}  // namespace crest
