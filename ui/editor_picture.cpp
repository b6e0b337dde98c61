#include "ui/editor_picture.h"

#include <fmt/core.h>

#include "presets/names.h"
#include "ui/plot.h"
#include "ui/style.h"
#include "ui/transfer_function_editor.h"
#include "ui/widgets.h"

namespace crest {
namespace {

std::string opacity_title(const TransferFunction& tf) {
  const char* unit = tf.unit == LengthUnit::voxel ? "voxels" : "world units";
  return fmt::format("opacity of {} {}", short_text(tf.unit_distance), unit);
}

std::string value_title(const TransferFunction& tf, const Volume* volume) {
  const std::string of = volume ? fmt::format(" of {}", volume->name) : "";
  return tf.domain == Domain::normalized ? fmt::format("value{}, as a share of its range", of) : "value" + of;
}

}  // namespace

void draw_editor_picture(const Document& document, const EditorState& editor, const StudioInputs& inputs,
                         ImVec2 size) {
  const TransferFunction& tf = document.preset.transfer_function;
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  const float line = ImGui::GetFontSize(), margin = scaled(8);
  const ValueRange visible = editor.visible.value_or(axis_range(tf, inputs.volume));
  const ImVec2 corner{0, line}, room{size.x - margin, size.y - 2 * line - scaled(4)};
  const Plot plot = make_plot(editor, corner, room, visible);

  EditorState unselected = editor;
  unselected.selection.clear();
  draw_plot_content(list, tf, unselected, plot, inputs);
  list.PushClipRect({plot.low.x - margin, plot.low.y - margin}, {plot.high.x + margin, plot.high.y + margin},
                    true);
  draw_points(list, plot, tf, unselected.selection, std::nullopt);
  list.PopClipRect();

  list.AddText({plot.low.x, plot.low.y - line - scaled(4)}, palette().text, opacity_title(tf).c_str());
  const std::string values = value_title(tf, inputs.volume);
  list.AddText({plot.high.x - ImGui::CalcTextSize(values.c_str()).x, size.y - line - scaled(5)},
               palette().text, values.c_str());
}

}  // namespace crest
