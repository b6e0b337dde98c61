#include "ui/value_curves.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "ui/point_tools.h"
#include "ui/style.h"
#include "ui/widgets.h"

namespace crest {
namespace {

constexpr std::array<std::string_view, 10> names = {
    "no curve", "values",    "values, log", "visibility", "visibility, log",
    "area",     "area, log", "gradient",    "volume",     "volume, log"};

constexpr double log_decades = 4;  // below the greatest, of what is no count
constexpr std::size_t most_marks = 8;
constexpr double same_value = 0.01;  // of the volume's range: a peak so near is the one that is suggested
constexpr float mark_reach = 7;      // pixels

bool is_logarithmic(ValueCurve curve) {
  return curve == ValueCurve::log_values || curve == ValueCurve::log_visibility ||
         curve == ValueCurve::log_area || curve == ValueCurve::log_enclosed;
}

std::vector<double> both_of(const Visibility& visibility) {
  std::vector<double> sum = visibility.volume;
  for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += visibility.surface[i];
  return sum;
}

/// A curve in equal bins over a range; without bins where it is not known.
struct Columns {
  ValueRange range;
  std::vector<double> of_bin;
};

Columns columns_of(const EditorState& editor, const StudioInputs& inputs) {
  const ByValue* by_value = inputs.by_value;
  switch (editor.value_curve) {
    case ValueCurve::none:
      break;
    case ValueCurve::values:
    case ValueCurve::log_values:
      return {editor.histogram.range, {editor.histogram.counts.begin(), editor.histogram.counts.end()}};
    case ValueCurve::visibility:
    case ValueCurve::log_visibility:
      if (inputs.visibility) return {inputs.visibility->range, both_of(*inputs.visibility)};
      break;
    case ValueCurve::area:
    case ValueCurve::log_area:
      if (by_value) return {by_value->range, surface_area(*by_value)};
      break;
    case ValueCurve::gradient:
      if (by_value) return {by_value->range, mean_gradient(*by_value)};
      break;
    case ValueCurve::enclosed:
    case ValueCurve::log_enclosed:
      if (by_value) return {by_value->range, enclosed_volume(*by_value)};
      break;
  }
  return {};
}

/// As shares of the plot's height. Counts begin at 1, the other curves have no least value.
std::vector<float> heights_of(const std::vector<double>& values, double most, ValueCurve curve) {
  std::vector<float> heights;
  for (const double value : values) {
    double height = value / most;
    if (curve == ValueCurve::log_values)
      height = std::log1p(value) / std::log1p(most);
    else if (is_logarithmic(curve))
      height = std::max(0.0, 1 + std::log10(std::max(height, 1e-300)) / log_decades);
    heights.push_back(float(height));
  }
  return heights;
}

/// Why there is no curve yet, or will be none.
std::string why_empty(const EditorState& editor, const StudioInputs& inputs) {
  const std::string& why =
      is_visibility(editor.value_curve) ? inputs.why_no_visibility : inputs.why_no_values;
  return why.empty() ? "measuring ..." : why;
}

bool has_peak_near(const StudioInputs& inputs, double value) {
  const double near = same_value * inputs.volume->statistics.range.width();
  return std::ranges::any_of(inputs.peaks,
                             [&](const Peak& peak) { return std::abs(peak.value - value) <= near; });
}

/// Where a suggested peak's mark is, its middle.
ImVec2 mark_place(const Plot& plot, double value) { return {plot.x_of(value), plot.high.y - scaled(9)}; }

/// Calls use(index, peak, its value on the axis) for each that is marked.
template <class Use>
void for_each_mark(const EditorState& editor, const StudioInputs& inputs, const Plot& plot,
                   ValueMap to_domain, Use&& use) {
  if (!editor.suggestions || !inputs.volume) return;
  const std::size_t count = std::min(inputs.suggested.size(), most_marks);
  for (std::size_t i = 0; i < count; ++i) {
    const double value = to_domain(inputs.suggested[i].value);
    const bool in_sight = value >= plot.axis.visible.min && value <= plot.axis.visible.max;
    if (in_sight && !has_peak_near(inputs, inputs.suggested[i].value)) use(i, inputs.suggested[i], value);
  }
}

bool is_at(ImVec2 mouse, ImVec2 place) {
  return std::abs(mouse.x - place.x) <= scaled(mark_reach) &&
         std::abs(mouse.y - place.y) <= scaled(mark_reach);
}

/// A surface has one value: its column is as wide as it takes to be seen beside its peak's stem.
void draw_surface_columns(ImDrawList& list, const Plot& plot, const Visibility& visibility,
                          const std::vector<float>& heights, double alpha, ValueMap to_domain) {
  const double bin_width = visibility.range.width() / double(visibility.bins());
  for (std::size_t i = 0; i < visibility.bins(); ++i) {
    if (!(visibility.surface[i] > 0)) continue;
    const float x = plot.x_of(to_domain(visibility.range.min + (double(i) + 0.5) * bin_width));
    const float top = plot.high.y - heights[i] * (plot.high.y - plot.low.y) * column_share;
    list.AddRectFilled({x - scaled(4), top}, {x + scaled(4), plot.high.y},
                       faded(palette().histogram_surface, float(alpha)));
  }
}

}  // namespace

void value_curve_choice(EditorState& editor, WidgetState& widgets, float room) {
  int index = int(editor.value_curve);
  float widest = 0;
  for (const std::string_view name : names) widest = std::max(widest, choice_width(std::string(name)));
  if (choice(widgets, "##histogram", index, names, std::clamp(room, scaled(60), widest)))
    editor.value_curve = ValueCurve(index);
  if (ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup)) return;
  tip("What lies behind the curve, by value:\n"
      "values: how many voxels have it\n"
      "visibility: how much of the picture it makes, in the preset's mode, from here\n"
      "area: of its isosurface\n"
      "gradient: how steep the field is there, on the mean: steep where materials meet\n"
      "volume: how much space has this value or more");
}

void draw_value_curve(ImDrawList& list, const Plot& plot, EditorState& editor, const StudioInputs& inputs,
                      ValueMap to_domain) {
  const ValueCurve curve = editor.value_curve;
  if (!inputs.volume || curve == ValueCurve::none) return;
  if (curve == ValueCurve::values || curve == ValueCurve::log_values) {
    const ValueRange visible = plot.axis.visible;
    update_histogram(editor.histogram, *inputs.volume,
                     {(visible.min - to_domain.offset) / to_domain.scale,
                      (visible.max - to_domain.offset) / to_domain.scale});
  }
  const Columns columns = columns_of(editor, inputs);
  if (columns.of_bin.empty()) {
    list.AddText({plot.low.x + scaled(8), plot.low.y + scaled(6)}, palette().secondary,
                 why_empty(editor, inputs).c_str());
    return;
  }
  const double most = *std::ranges::max_element(columns.of_bin);
  if (!(most > 0)) return;
  const std::vector<float> heights = heights_of(columns.of_bin, most, curve);
  if (!is_visibility(curve))
    return draw_columns(list, plot, columns.range, heights, palette().histogram, 1, to_domain);
  const double alpha = inputs.visibility_is_old ? 0.5 : 1;
  draw_columns(list, plot, columns.range, heights_of(inputs.visibility->volume, most, curve),
               palette().histogram, alpha, to_domain);
  draw_surface_columns(list, plot, *inputs.visibility, heights, alpha, to_domain);
}

namespace {

/// How many voxels are in the column that is drawn there.
std::string count_text(const HistogramCache& histogram, double value) {
  const double width = histogram.range.width(), columns = double(histogram.counts.size());
  if (!(width > 0) || histogram.counts.empty()) return "";
  const double at = (value - histogram.range.min) / width * columns;
  if (!(at >= 0) || at > columns) return "";
  const auto count = histogram.counts[std::size_t(std::min(at, columns - 1))];
  return fmt::format("{} voxel{} in this column", count, count == 1 ? "" : "s");
}

}  // namespace

std::string value_curve_text(const EditorState& editor, const StudioInputs& inputs, double value) {
  if (editor.value_curve == ValueCurve::none) return "";
  if (editor.value_curve <= ValueCurve::log_values) return count_text(editor.histogram, value);
  const Columns columns = columns_of(editor, inputs);
  const double width = columns.range.width();
  if (columns.of_bin.empty() || !(width > 0) || value < columns.range.min || value > columns.range.max)
    return "";
  const double count = double(columns.of_bin.size());
  const std::size_t bin = std::size_t(std::min((value - columns.range.min) / width * count, count - 1));
  const double found = columns.of_bin[bin];
  switch (editor.value_curve) {
    case ValueCurve::none:
    case ValueCurve::values:
    case ValueCurve::log_values:
      break;
    case ValueCurve::visibility:
    case ValueCurve::log_visibility: {
      double all = 0;
      for (const double share : columns.of_bin) all += share;
      return all > 0 ? fmt::format("{:.3g} % of the picture", 100 * found / all) : "";
    }
    case ValueCurve::area:
    case ValueCurve::log_area:
      return fmt::format("surface area {:.4g}", found);
    case ValueCurve::gradient:
      return fmt::format("mean gradient {:.4g}", found);
    case ValueCurve::enclosed:
    case ValueCurve::log_enclosed:
      return fmt::format("volume above {:.4g}", found);
  }
  return "";
}

bool suggested_peak_clicked(TransferFunction& tf, StudioState& state, const StudioInputs& inputs,
                            const Plot& plot, ValueMap to_domain) {
  bool taken = false;
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const bool hovered = ImGui::IsItemHovered() && state.editor.drag.kind == EditorDrag::Kind::none &&
                       !point_near(plot, tf.points, mouse);
  for_each_mark(
      state.editor, inputs, plot, to_domain, [&](std::size_t i, const SuggestedPeak& peak, double value) {
        const ImVec2 place = mark_place(plot, value);
        state.widgets.items[fmt::format("suggestion/{}", i)] = {place, place};
        if (taken || !hovered || !is_at(mouse, place)) return;
        ImGui::SetTooltip(
            "A boundary at %s?\nThe mean gradient is highest there: %.4g.\nClick to add a spike",
            short_text(value).c_str(), peak.gradient);
        if (!ImGui::IsMouseClicked(ImGuiMouseButton_Left)) return;
        taken = add_shape(tf, state.editor, Shape::spike,
                          round_to_resolution(value, plot.axis.value_per_pixel()), 0.8, plot.axis.visible);
      });
  return taken;
}

void draw_suggested_peaks(ImDrawList& list, const EditorState& editor, const StudioInputs& inputs,
                          const Plot& plot, ValueMap to_domain) {
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  for_each_mark(editor, inputs, plot, to_domain, [&](std::size_t, const SuggestedPeak& peak, double value) {
    const ImVec2 at = mark_place(plot, value);
    const float size = scaled(float(3.5 + 2 * peak.persistence));
    const bool hovered = ImGui::IsItemHovered() && is_at(mouse, at);
    const ImVec2 top{at.x, at.y - size}, left{at.x - size, at.y + size}, right{at.x + size, at.y + size};
    list.AddTriangleFilled(top, right, left, hovered ? palette().text : palette().accent);
    list.AddTriangle(top, right, left, palette().plot, 1);
  });
}

}  // namespace crest
