#include "ui/point_tools.h"

#include <fmt/core.h>

#include <algorithm>
#include <cctype>

#include "ui/actions.h"
#include "ui/arrange_points.h"
#include "ui/clipboard.h"
#include "ui/curve_beneath.h"
#include "ui/number_field.h"

namespace crest {
namespace {

constexpr double share_of_view = 0.02, wide_share = 0.1;  // widths of new shapes
constexpr double new_opacity = 0.8;

bool item(WidgetState& widgets, const char* text, const std::string& keys = "", bool enabled = true) {
  const bool chosen = ImGui::MenuItem(text, keys.c_str(), false, enabled);
  note_item(widgets, text);
  return chosen;
}

bool take(TransferFunction& tf, EditorState& editor, const Moved& result) {
  editor.selection = result.of(editor.selection);
  const bool changed = result.points != tf.points;
  tf.points = result.points;
  return changed;
}

bool copy_items(TransferFunction& tf, EditorState& editor, WidgetState& widgets, ValueRange volume,
                ValueRange visible) {
  const bool any = !editor.selection.empty();
  bool changed = false;
  if (item(widgets, "Copy", key_text_of("Copy"), any)) copy_points(tf, editor);
  if (item(widgets, "Cut", key_text_of("Cut"), any)) changed |= cut_points(tf, editor);
  if (item(widgets, "Paste", key_text_of("Paste"))) changed |= paste_points(tf, editor, volume, visible);
  return changed;
}

bool align_items(TransferFunction& tf, EditorState& editor, WidgetState& widgets) {
  constexpr std::pair<const char*, Alignment> values[] = {{"To the first", Alignment::least},
                                                          {"To their mean", Alignment::mean},
                                                          {"To the last", Alignment::greatest}};
  constexpr std::pair<const char*, Alignment> opacities[] = {{"To the lowest", Alignment::least},
                                                             {"To the mean height", Alignment::mean},
                                                             {"To the highest", Alignment::greatest}};
  const bool several = editor.selection.size() > 1;
  bool changed = false;
  const auto menu = [&](const char* title) {
    const bool open = ImGui::BeginMenu(title, several);
    note_item(widgets, title);
    return open;
  };
  if (menu("Align opacities")) {
    for (const auto& [text, alignment] : opacities)
      if (item(widgets, text)) {
        edit_above_curve(tf, [&] { align_opacities(tf, editor.selection, alignment); });
        changed = true;
      }
    ImGui::EndMenu();
  }
  if (menu("Align values")) {
    for (const auto& [text, alignment] : values)
      if (item(widgets, text))
        changed |= take(tf, editor, with_values_aligned(tf, editor.selection, alignment));
    ImGui::EndMenu();
  }
  return changed;
}

bool arrange_items(TransferFunction& tf, EditorState& editor, WidgetState& widgets) {
  const bool three = editor.selection.size() > 2;
  bool changed = align_items(tf, editor, widgets);
  if (item(widgets, "Distribute values", "", three))
    changed |= take(tf, editor, with_values_distributed(tf, editor.selection));
  if (item(widgets, "Opacities on a line", "", three)) {
    edit_above_curve(tf, [&] { interpolate_opacities(tf, editor.selection); });
    changed = true;
  }
  if (item(widgets, "Mirror")) {
    const Selection mirrored_points = selected_or_all(tf, editor.selection);
    tf.points = mirrored(tf, mirrored_points).points;
    changed = true;
  }
  tip("Left and right, of the selected points, or of all");
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted("Opacities times");
  ImGui::SameLine();
  double factor = 1;
  if (number_field(widgets, "##opacity factor", factor, FieldRule{.min = 0, .max = 1e6}, scaled(70))) {
    edit_above_curve(tf, [&] {
      scale_opacities(tf, editor.selection.empty() ? everything(tf) : editor.selection, factor);
    });
    changed = true;
  }
  tip("Of the selected points, or of all; 0 stays 0, and 1 is the most");
  return changed;
}

void rule_items(EditorState& editor, WidgetState& widgets) {
  constexpr std::pair<const char*, Neighbours> rules[] = {{"Pass their neighbours", Neighbours::free},
                                                          {"Stop at their neighbours", Neighbours::stop},
                                                          {"Push their neighbours", Neighbours::push}};
  ImGui::TextDisabled("Points that move");
  for (const auto& [text, rule] : rules) {
    if (ImGui::MenuItem(text, nullptr, editor.neighbours == rule)) editor.neighbours = rule;
    note_item(widgets, text);
  }
  ImGui::MenuItem("Snap while dragged", "Alt: not", &editor.snap);
  note_item(widgets, "Snap while dragged");
  tip("To other points, to the histogram's maxima and to the marks on the axis");
}

}  // namespace

std::string adding(Shape shape) {
  std::string label(label_of(shape));
  if (shape != Shape::gaussian) label.front() = char(std::tolower(label.front()));
  return "Add " + label;
}

double new_width(const TransferFunction& tf, const EditorState& editor, Shape shape, ValueRange visible) {
  const double share = (shape == Shape::spike ? share_of_view : wide_share) * visible.width();
  const double width = round_to_resolution(share, 0.1 * share);
  // What was typed for another axis is none for this one, and only a spike has no width
  const std::optional<double> typed = editor.new_peak_width;
  if (typed && *typed <= visible.width() && (*typed > 0 || shape == Shape::spike)) return *typed;
  return shape == Shape::spike ? std::min(width, widest_spike(tf)) : width;
}

bool add_shape(TransferFunction& tf, EditorState& editor, Shape shape, double value, double opacity,
               ValueRange visible) {
  const double width = new_width(tf, editor, shape, visible);
  editor.selection = insert_shape(tf, shape, value, opacity, width, peak_color(tf.points.size() / 3));
  editor.type_value = true;
  return true;
}

bool add_shape(TransferFunction& tf, EditorState& editor, Shape shape, ValueRange visible) {
  const double middle = widest_gap(tf, visible);
  return add_shape(tf, editor, shape, round_to_resolution(middle, 0.01 * visible.width()), new_opacity,
                   visible);
}

bool shapes_menu(TransferFunction& tf, EditorState& editor, WidgetState& widgets, ValueRange visible) {
  bool changed = false;
  for (const Shape shape : {Shape::spike, Shape::tent, Shape::box, Shape::gaussian, Shape::ramp, Shape::step})
    if (item(widgets, std::string(label_of(shape)).c_str(), key_text_of(adding(shape))))
      changed |= add_shape(tf, editor, shape, visible);
  ImGui::Separator();
  ImGui::TextDisabled("Opacities of all; colours stay");
  for (const OpacityShape shape : {OpacityShape::flat, OpacityShape::ramp_up, OpacityShape::ramp_down,
                                   OpacityShape::tent, OpacityShape::gaussian})
    if (item(widgets, std::string(label_of(shape)).c_str())) {
      const TransferFunction before = tf;
      tf = with_opacities(tf, shape, new_opacity);
      if (tf.points.size() != before.points.size()) editor.selection.clear();
      changed |= !(tf == before);
    }
  return changed;
}

bool points_menu(TransferFunction& tf, EditorState& editor, WidgetState& widgets, ValueRange volume,
                 ValueRange visible) {
  bool changed = copy_items(tf, editor, widgets, volume, visible);
  ImGui::Separator();
  changed |= arrange_items(tf, editor, widgets);
  ImGui::Separator();
  rule_items(editor, widgets);
  return changed;
}

}  // namespace crest
