#include "ui/accuracy_panel.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "ui/accuracy_answers.h"
#include "ui/accuracy_shown.h"
#include "ui/accuracy_table.h"
#include "ui/number_field.h"
#include "ui/style.h"

namespace crest {
namespace {

constexpr float least_diagram = 150;  // pixels of height, before the panel scrolls
constexpr std::size_t most_told = 24;

std::string status_of(const AccuracyResults& results) {
  const std::string points =
      fmt::format("{} point{}", results.measured.size(), results.measured.size() == 1 ? "" : "s");
  if (results.is_running)
    return fmt::format("{}{}{}", results.measured.empty() || results.is_stale ? "" : points + "   ",
                       results.doing, results.done > 0 ? fmt::format("   {:.0f} %", 100 * results.done) : "");
  if (results.measured.empty()) return "";
  if (results.is_stale) return "of a scene or view that has changed since";
  return fmt::format("{} of {} x {} pixels{}", points, results.size.x, results.size.y,
                     results.is_on ? ": all is measured" : "");
}

void switch_row(StudioState& state, const StudioInputs& inputs, const AccuracyResults& results,
                StudioRequests& requests) {
  ImGui::BeginDisabled(!inputs.volume && !results.is_on);
  const bool stops = results.is_on && (results.is_running || results.is_stale);
  const bool again = !stops && !results.measured.empty();
  const char* text = stops ? "Stop" : again ? "Measure again" : "Measure";
  const float width = ImGui::CalcTextSize("Measure again").x + 2 * ImGui::GetStyle().FramePadding.x;
  if (ImGui::Button(fmt::format("{}##measure", text).c_str(), {width, 0})) requests.measure = !stops;
  note_item(state.widgets, "measure");
  note_item(state.widgets, fmt::format("measure/{}", text));
  ImGui::EndDisabled();
  tip(stops ? "Stops; what was measured stays.\nUntil then, a change of the transfer function, the "
              "volume,\nthe camera or the clip box measures anew."
            : "Measures this scene and view in the background:\nthe exact answers, then each method "
              "from coarse steps to fine ones");
  ImGui::SameLine();
  ImGui::AlignTextToFramePadding();
  if (!results.error.empty())
    ImGui::TextColored(ImGui::ColorConvertU32ToFloat4(palette().error), "%s", results.error.c_str());
  else
    ImGui::TextDisabled("%s", status_of(results).c_str());
  if (!results.error.empty()) tip(results.error.c_str());
}

void target_row(TargetError& target, WidgetState& widgets) {
  const auto measures = error_measures();
  std::vector<std::string_view> names;
  for (const ErrorMeasure& measure : measures) names.push_back(measure.name);
  int index = int(target.measure - measures.data());
  const float field = scaled(70), gap = ImGui::GetStyle().ItemSpacing.x;
  const float label = ImGui::CalcTextSize("at most").x + ImGui::GetStyle().ItemInnerSpacing.x;
  const float room = ImGui::GetContentRegionAvail().x - field - gap - label;
  if (choice(widgets, "##error measure", index, names, std::clamp(room, scaled(80), scaled(300))))
    target.measure = &measures[std::size_t(index)];
  tip("The error up the diagram, over premultiplied RGBA in [0, 1]");
  ImGui::SameLine();
  field_label("at most");
  number_field(widgets, "##target error", target.most, unit_interval, field);
  tip("The target. Filled marks meet it; the cheapest of them is recommended.");
}

void target_verdict(WidgetState& widgets, const ShownAccuracy& shown) {
  const std::string text = shown.results.is_stale ? "" : verdict_text(shown);
  if (text.empty()) return;
  const ImU32 color = shown.recommended ? palette().good : palette().warning;
  ImGui::PushTextWrapPos();
  ImGui::TextColored(ImGui::ColorConvertU32ToFloat4(color), "%s", text.c_str());
  ImGui::PopTextWrapPos();
  note_item(widgets, "verdict: " + text);
}

void point_tooltip(const ShownAccuracy& shown, std::size_t index, float bottom) {
  const Measurement& m = shown.results.measured[index];
  const Method* method = find_method(m.method);
  const ImageError& error = *m.error_against(shown.answer);
  const float column = scaled(74);
  const auto row = [&](std::string_view value, std::string_view text) {
    const float x = ImGui::GetCursorPosX();
    ImGui::TextUnformatted(value.data(), value.data() + value.size());
    ImGui::SameLine(x + column);
    ImGui::PushStyleColor(ImGuiCol_Text, palette().secondary);
    ImGui::TextUnformatted(text.data(), text.data() + text.size());
    ImGui::PopStyleColor();
  };
  // Above the diagram, so that it hides none of it
  const float width = column + scaled(250) + 2 * ImGui::GetStyle().WindowPadding.x;
  const float most_x = std::max(ImGui::GetIO().DisplaySize.x - width, 0.0F);
  const float x = std::clamp(ImGui::GetIO().MousePos.x - width / 2, 0.0F, most_x);
  ImGui::SetNextWindowPos({x, std::max(bottom, scaled(250))}, ImGuiCond_Always, {0, 1});
  ImGui::BeginTooltip();
  ImGui::PushStyleColor(ImGuiCol_Text, color_of(*method));
  ImGui::TextUnformatted(method->name.data(), method->name.data() + method->name.size());
  ImGui::PopStyleColor();
  ImGui::Separator();
  if (method->has_step) row(step_text(m.step), "step, in the smallest spacing");
  row(ms_text(m.frame_ms), "ms a frame");
  row(fmt::format("{:.4g}", m.samples_per_ray),
      fmt::format("samples a ray, {:.4g} for DVR", m.dvr_samples_per_ray));
  ImGui::Separator();
  for (const ErrorMeasure& measure : error_measures())
    if (const double value = measure.value(error); std::isfinite(value))
      row(fmt::format("{:.3g}", value), measure.name);
  if (const double grazing = error.grazing_share(); grazing > 0)
    row(fmt::format("{:.3g}", grazing), "share of grazing pixels, left out");
  ImGui::Separator();
  ImGui::TextDisabled("%s", shown.recommended == index
                                ? "The cheapest that meets the target. Click to use it."
                                : "Click to render with this setting.");
  ImGui::EndTooltip();
}

/// Why there is no point, in the middle of where they would be.
void hint(ImDrawList& list, const ShownAccuracy& shown, ImVec2 low, ImVec2 high) {
  const char* text =
      "Measure draws what each method makes of this scene and view:\n"
      "its error against the exact answer, over the time of a frame,\n"
      "at steps from 4 down to 1/64 of the smallest spacing.";
  if (!shown.results.measured.empty())
    text = shown.results.is_running ? "No point against this answer yet."
                                    : "No method was measured against this answer.";
  else if (shown.results.is_running)
    text = "The first points come when the first exact answer is there.";
  const float wrap = high.x - low.x - scaled(16);
  const ImVec2 size = ImGui::CalcTextSize(text, nullptr, false, wrap);
  list.PushClipRect(low, high, true);
  list.AddText(ImGui::GetFont(), ImGui::GetFontSize(),
               {std::max(low.x + scaled(8), std::round((low.x + high.x - size.x) / 2)),
                std::round((low.y + high.y - size.y) / 2)},
               palette().secondary, text, nullptr, wrap);
  list.PopClipRect();
}

void draw_diagram(ImDrawList& list, const AccuracyPlot& plot, const ShownAccuracy& shown,
                  std::string_view emphasized, std::optional<std::size_t> hovered) {
  const float presence = shown.results.is_stale ? 0.35F : 1;
  const double most = shown.target.most;
  list.PushClipRect({plot.low.x, plot.low.y}, {plot.high.x + 1, plot.high.y + 1}, true);
  draw_target(list, plot, most);
  draw_front(list, plot, shown.front);
  for (const MethodLine& line : shown.lines) {
    const bool is_it = line.method->id == emphasized;
    draw_line(list, plot, line, most, presence * (emphasized.empty() || is_it ? 1.0F : 0.45F), is_it);
  }
  if (shown.recommended && !shown.results.is_stale)
    draw_ring(list, plot, shown.point_of(*shown.recommended), scaled(10), palette().good, "recommended",
              false);
  if (shown.present_point)
    draw_ring(list, plot, *shown.present_point, scaled(7), palette().emphasis, "present", true);
  if (hovered)
    list.AddCircle(plot.place(shown.point_of(*hovered)), scaled(8), palette().accent, 24, scaled(1.6F));
  list.PopClipRect();
}

bool diagram(Document& document, StudioState& state, const ShownAccuracy& shown, float height) {
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const ImVec2 size{std::max(ImGui::GetContentRegionAvail().x, scaled(100)), height};
  const bool clicked = ImGui::InvisibleButton("##accuracy plot", size);
  note_item(state.widgets, "accuracy plot");
  const AccuracyPlot plot =
      accuracy_plot(shown.lines, shown.target.most, corner, {corner.x + size.x, corner.y + size.y});
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(plot.low, plot.high, palette().plot);
  if (shown.results.is_running) {
    const float done = float(std::clamp(shown.results.done, 0.0, 1.0)) * (plot.high.x - plot.low.x);
    list.AddRectFilled({plot.low.x, plot.low.y - scaled(2)}, {plot.low.x + done, plot.low.y},
                       palette().accent);
  }
  if (shown.lines.empty()) {
    hint(list, shown, plot.low, plot.high);
    return false;
  }
  draw_axes(list, plot);
  const auto& measured = shown.results.measured;
  for (const MethodLine& line : shown.lines)
    for (const AnswerPoint& p : line.points) {
      const ImVec2 at = plot.place(p.point);
      state.widgets.items[fmt::format("measured/{}/{}", line.method->id, measured[p.index].step)] = {at, at};
    }
  const auto hovered = ImGui::IsItemHovered() || clicked
                           ? point_near(plot, shown.lines, ImGui::GetIO().MousePos)
                           : std::nullopt;
  draw_diagram(list, plot, shown,
               hovered ? std::string_view(measured[*hovered].method) : state.accuracy.hovered_method,
               hovered);
  if (hovered) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
  if (hovered && !clicked) point_tooltip(shown, *hovered, corner.y);
  return clicked && hovered && apply_setting(document, state.accuracy, shown, *hovered);
}

/// On what it was measured, and what was not.
void footnote(const AccuracyResults& results) {
  ImGui::TextDisabled("%d x %d pixels, timed beside this window", results.size.x, results.size.y);
  if (ImGui::IsItemHovered())
    ImGui::SetTooltip(
        "%s\nThe times are of a machine that the window and other programs share:\nthey order the methods, "
        "but "
        "vary from run to run. For times to quote use crest report.\nShading and early termination are off "
        "while it measures.",
        results.renderer.c_str());
  if (results.left_out.empty()) return;
  ImGui::SameLine(0, scaled(16));
  ImGui::TextDisabled("%zu left out", results.left_out.size());
  if (!ImGui::IsItemHovered()) return;
  ImGui::BeginTooltip();
  for (std::size_t i = 0; i < std::min(results.left_out.size(), most_told); ++i)
    ImGui::Text("%s: %s", results.left_out[i].what.c_str(), results.left_out[i].why.c_str());
  if (results.left_out.size() > most_told)
    ImGui::TextDisabled("and %zu more", results.left_out.size() - most_told);
  ImGui::EndTooltip();
}

}  // namespace

bool accuracy_panel(Document& document, StudioState& state, const StudioInputs& inputs,
                    StudioRequests& requests) {
  static const AccuracyResults nothing;
  const AccuracyResults& results = inputs.accuracy ? *inputs.accuracy : nothing;
  const ShownAccuracy shown = shown_accuracy(results, state.accuracy, document.preset.rendering);
  switch_row(state, inputs, results, requests);
  answer_rows(state, shown);
  target_row(state.accuracy.target, state.widgets);
  target_verdict(state.widgets, shown);
  const ImGuiStyle& style = ImGui::GetStyle();
  const float row = ImGui::GetFontSize() + 2 * style.CellPadding.y;
  const float table = shown.lines.empty() ? 0 : row * float(shown.lines.size() + 1) + style.ItemSpacing.y;
  const float note = results.measured.empty() ? 0 : ImGui::GetTextLineHeightWithSpacing();
  const float room = ImGui::GetContentRegionAvail().y - table - note - style.ItemSpacing.y;
  bool changed = diagram(document, state, shown, std::max(room, scaled(least_diagram)));
  changed |= accuracy_table(document, state, shown);
  if (!results.measured.empty()) footnote(results);
  return changed;
}

}  // namespace crest
