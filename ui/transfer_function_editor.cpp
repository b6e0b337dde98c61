#include "ui/transfer_function_editor.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "presets/number_text.h"
#include "ui/editor_fields.h"
#include "ui/plot.h"
#include "ui/plot_interaction.h"
#include "ui/plot_menu.h"
#include "ui/point_tools.h"
#include "ui/shown_values.h"
#include "ui/snap.h"
#include "ui/style.h"
#include "ui/value_curves.h"

namespace crest {
namespace {

ValueRange volume_range(const Volume* volume) { return volume ? volume->statistics.range : ValueRange{0, 1}; }

}  // namespace

Plot make_plot(const EditorState& editor, ImVec2 corner, ImVec2 size, ValueRange visible) {
  Plot plot;
  const float gutter = scaled(42), strip = axis_ticks(visible, 8).offset.empty() ? scaled(28) : scaled(44);
  plot.low = {corner.x + gutter, corner.y + scaled(span_height)};
  plot.high = {std::max(plot.low.x + 8, corner.x + size.x - scaled(8)),
               std::max(plot.low.y + 8, corner.y + size.y - strip)};
  plot.axis = {visible, double(plot.low.x), double(plot.high.x - plot.low.x)};
  plot.opacity_axis = editor.opacity_axis;
  return plot;
}

void draw_plot_content(ImDrawList& list, const TransferFunction& tf, EditorState& editor, const Plot& plot,
                       const StudioInputs& inputs) {
  draw_axes(list, plot);
  list.PushClipRect(plot.low, plot.high, true);
  const ValueMap to_domain = data_to_domain(tf, volume_range(inputs.volume));
  draw_value_curve(list, plot, editor, inputs, to_domain);
  draw_curve(list, plot, tf);
  draw_peaks(list, plot, tf, inputs.peaks);
  list.PopClipRect();
  list.AddRect(plot.low, plot.high, palette().frame);
}

namespace {

void draw_plot(const TransferFunction& tf, EditorState& editor, const Plot& plot,
               const StudioInputs& inputs) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  draw_plot_content(list, tf, editor, plot, inputs);
  list.PushClipRect(plot.low, plot.high, true);
  const ValueMap to_domain = data_to_domain(tf, volume_range(inputs.volume));
  draw_suggested_peaks(list, editor, inputs, plot, to_domain);
  list.PopClipRect();
  const float margin = scaled(8);
  list.PushClipRect({plot.low.x - margin, plot.low.y - margin}, {plot.high.x + margin, plot.high.y + margin},
                    true);
  if (editor.drag.snapped) {
    const float x = plot.x_of(*editor.drag.snapped);
    list.AddLine({x, plot.low.y}, {x, plot.high.y}, palette().accent);
  }
  const bool free = ImGui::IsItemHovered() && editor.drag.kind == EditorDrag::Kind::none;
  draw_points(list, plot, tf, editor.selection,
              free ? point_near(plot, tf.points, ImGui::GetIO().MousePos) : std::nullopt);
  if (editor.drag.kind == EditorDrag::Kind::box && editor.drag.under_way)
    list.AddRect(editor.drag.start, ImGui::GetIO().MousePos, palette().accent);
  list.PopClipRect();
  const ValueRange span = span_of(tf, editor.selection);
  draw_span(list, plot, span,
            free ? span_handle_at(plot, span, ImGui::GetIO().MousePos) : std::optional(editor.drag.kind));
  if (!editor.note.empty())
    list.AddText({plot.low.x + scaled(6), plot.high.y - ImGui::GetFontSize() - scaled(4)}, palette().warning,
                 editor.note.c_str());
}

/// What is at the mouse, in lines.
std::string place_text(const TransferFunction& tf, const EditorState& editor, const StudioInputs& inputs,
                       const Plot& plot, ValueMap to_domain) {
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const double value = round_to_resolution(plot.axis.value_at(mouse.x), plot.axis.value_per_pixel());
  std::string text = fmt::format("value {}\nopacity {:.3g}, here {:.3g}", exact_text(value),
                                 evaluate(tf, value).opacity, plot.opacity_at(mouse.y));
  if (!inputs.volume) return text;
  const std::string of_value =
      value_curve_text(editor, inputs, (plot.axis.value_at(mouse.x) - to_domain.offset) / to_domain.scale);
  return of_value.empty() ? text : text + "\n" + of_value;
}

/// Beside the mouse, on the side where there is room.
void draw_readout(const Plot& plot, const std::string& text) {
  const ImVec2 mouse = ImGui::GetIO().MousePos, size = ImGui::CalcTextSize(text.c_str());
  const float gap = scaled(16);
  const bool fits = mouse.x + gap + size.x + scaled(6) < plot.high.x;
  const ImVec2 at{fits ? mouse.x + gap : mouse.x - gap - size.x,
                  std::clamp(mouse.y + gap, plot.low.y + scaled(4),
                             std::max(plot.low.y + scaled(4), plot.high.y - size.y - scaled(4)))};
  text_on_picture(*ImGui::GetWindowDrawList(), at, text);
}

/// Which values the axis is in.
void value_switch(const TransferFunction& tf, StudioState& state, const StudioInputs& inputs) {
  const auto option = [&](const char* text, const char* name, bool data, const char* meaning) {
    const bool is_on = tf.domain == (data ? Domain::data : Domain::normalized);
    ImGui::PushStyleColor(ImGuiCol_Button,
                          ImGui::GetStyleColorVec4(is_on ? ImGuiCol_HeaderActive : ImGuiCol_FrameBg));
    if (ImGui::Button(text)) state.settings.data_values = data;
    ImGui::PopStyleColor();
    note_item(state.widgets, name);
    tip(meaning);
  };
  ImGui::BeginDisabled(!inputs.volume);
  option("Data", "values/data", true, "The axis and all fields are in the volume's values");
  ImGui::SameLine(0, scaled(2));
  option("0 to 1", "values/normalized", false, "From the volume's least value, 0, to its greatest, 1");
  ImGui::EndDisabled();
}

/// What is seen of the axis, and widths, belong to the values that it is in.
void follow_shown_values(EditorState& editor, const TransferFunction& stored, Domain shown,
                         const Volume* volume) {
  const std::optional<Domain> domain = std::exchange(editor.shown_domain, shown);
  const std::optional<ValueRange> range = editor.shown_range;
  editor.shown_range = volume ? std::optional(volume->statistics.range) : std::nullopt;
  // Values that are no conversion mean the same with any volume
  const bool is_converted = volume && stored.domain != shown;
  if (!domain || (*domain == shown && (!is_converted || range == editor.shown_range))) return;
  editor.visible.reset();
  editor.new_peak_width.reset();
}

/// A press ends what was noted, and may begin a drag that snaps to what the volume has.
void note_press(const TransferFunction& tf, EditorState& editor, const Volume* volume) {
  editor.note.clear();
  editor.landmarks.clear();
  if (!volume) return;
  const ValueMap to_domain = data_to_domain(tf, volume->statistics.range);
  for (const double value : histogram_maxima(volume->statistics))
    editor.landmarks.push_back(to_domain(value));
}

}  // namespace

ValueRange axis_range(const TransferFunction& tf, const Volume* volume) {
  const ValueRange range = range_in_domain(tf, volume_range(volume));
  if (tf.points.empty()) return whole_range(range, range);
  const ValueRange span = tf.range();
  return whole_range(volume || tf.domain == Domain::normalized ? range : span, span);
}

ValueRange visible_values(const TransferFunction& tf, const EditorState& editor, const Volume* volume) {
  return editor.visible.value_or(axis_range(tf, volume));
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

void follow_shown_values(StudioState& state, const TransferFunction& stored, const StudioInputs& inputs) {
  follow_shown_values(state.editor, stored, shown_domain(stored, state.settings, inputs.volume != nullptr),
                      inputs.volume);
}

void trim_selection(EditorState& editor, const TransferFunction& tf) {
  std::erase_if(editor.selection, [&](std::size_t i) { return i >= tf.points.size(); });
}

bool transfer_function_editor(Document& document, StudioState& state, const StudioInputs& inputs) {
  TransferFunction& tf = document.preset.transfer_function;
  EditorState& editor = state.editor;
  trim_selection(editor, tf);
  const bool dragging = editor.drag.moves_points();
  // The axis holds still while points are dragged beyond its ends.
  const ValueRange whole = dragging ? editor.drag.whole : axis_range(tf, inputs.volume);
  if (editor.visible && !dragging) editor.visible = pan(*editor.visible, whole, 0);
  const ValueRange visible = dragging ? editor.drag.visible : editor.visible.value_or(whole);

  if (ImGui::IsMouseClicked(ImGuiMouseButton_Left)) note_press(tf, editor, inputs.volume);
  bool changed = editor_toolbar(tf, editor, state.widgets, volume_range(inputs.volume), visible);
  changed |= point_fields(tf, editor, state.widgets);
  const float below = ImGui::GetFrameHeightWithSpacing() * (editor.peak_rule ? 2.0F : 1.0F);
  const ImVec2 corner = ImGui::GetCursorScreenPos(), room = ImGui::GetContentRegionAvail();
  const ImVec2 size{std::max(room.x, scaled(100)), std::max(room.y - below, scaled(90))};
  ImGui::InvisibleButton("##plot", size,
                         ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight |
                             ImGuiButtonFlags_MouseButtonMiddle);
  Plot plot = make_plot(editor, corner, size, visible);
  const ImVec2 pixel = ImGui::GetIO().DisplayFramebufferScale;
  state.picture_dialog.editor_as_shown = {int(size.x * std::max(pixel.x, 1.0F)),
                                          int(size.y * std::max(pixel.y, 1.0F))};

  take_focus(state.navigation, Area::editor);
  const ImGuiID id = ImGui::GetID("##plot");
  const bool has_arrows = takes_arrows(state.navigation) || !is_navigating();
  state.widgets.items["plot"] = {plot.low, plot.high};
  for (std::size_t i = 0; i < tf.points.size(); ++i) {
    const ImVec2 at = plot.place(tf.points[i]);
    state.widgets.items[fmt::format("point/{}", i)] = {at, at};
  }
  const ValueRange span = span_of(tf, editor.selection);
  const float span_y = plot.low.y - scaled(span_height / 2);
  state.widgets.items["span/low"] = {{plot.x_of(span.min), span_y}, {plot.x_of(span.min), span_y}};
  state.widgets.items["span/high"] = {{plot.x_of(span.max), span_y}, {plot.x_of(span.max), span_y}};
  const ValueMap to_domain = data_to_domain(tf, volume_range(inputs.volume));
  if (suggested_peak_clicked(tf, state, inputs, plot, to_domain))
    changed = true;
  else
    changed |= handle_plot_mouse(tf, editor, plot, whole);
  if (ImGui::IsItemHovered()) state.under_cursor = place_text(tf, editor, inputs, plot, to_domain);
  const bool keys_are_free = !ImGui::GetIO().WantTextInput && !ImGui::IsAnyItemActive() &&
                             !ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup);
  if (keys_are_free && has_arrows) changed |= handle_plot_keys(tf, editor, plot);
  draw_plot(tf, editor, plot, inputs);
  show_focus(id, plot.low, plot.high);
  if (ImGui::IsItemHovered() && !state.under_cursor.empty()) draw_readout(plot, state.under_cursor);
  changed |= plot_menus(document, editor, state.widgets, inputs, visible);
  value_switch(tf, state, inputs);
  ImGui::SameLine();
  changed |= unit_fields(tf, state.widgets);
  ImGui::SameLine();
  if (ImGui::ArrowButton("##peak rule", editor.peak_rule ? ImGuiDir_Down : ImGuiDir_Right))
    editor.peak_rule = !editor.peak_rule;
  note_item(state.widgets, "peak rule");
  tip("The peak rule: what counts as a peak, and as a spike");
  ImGui::SameLine(0, ImGui::GetStyle().ItemInnerSpacing.x);
  shortened_text("peak rule", ImGui::GetContentRegionAvail().x, palette().secondary);
  if (editor.peak_rule) changed |= peak_rule_fields(tf, state.widgets);
  return changed;
}

}  // namespace crest
