#include "ui/ray_panel.h"

#include <fmt/core.h>
#include <imgui_internal.h>

#include <algorithm>

#include "ui/mode_text.h"
#include "ui/questions.h"
#include "ui/ray_plot.h"
#include "ui/style.h"

namespace crest {
namespace {

constexpr double zoom_per_notch = 0.8;

void mode_buttons(StudioState& state) {
  for (const Mode mode : view_modes) {
    const bool is_shown = state.ray.mode == mode;
    ImGui::PushStyleColor(ImGuiCol_Button,
                          ImGui::GetStyleColorVec4(is_shown ? ImGuiCol_HeaderActive : ImGuiCol_FrameBg));
    if (ImGui::Button(fmt::format("{}##ray", title_of(mode)).c_str())) state.ray.mode = mode;
    ImGui::PopStyleColor();
    note_item(state.widgets, fmt::format("ray mode/{}", name_of(mode)));
    tip(fmt::format("{}: {}", name_of(mode), explanation_of(mode)).c_str());
    ImGui::SameLine(0, scaled(3));
  }
  if (ImGui::Button("Close##ray")) state.ray.ask.reset();
  note_item(state.widgets, "close ray");
}

/// What was found and missed, in a line; and how far the opacity is off.
std::string summary(const InspectedRay& ray) {
  const double exact = ray.exact.places.empty() ? 0 : ray.exact.places.back().opacity;
  if (ray.steps.empty())
    return fmt::format("Opacity {:.4g}, {} crossings{}", exact, ray.crossings.exact.size(),
                       ray.why_no_steps.empty() ? "" : "; as drawn: " + ray.why_no_steps);
  const int missed = ray.crossings.missed();
  std::string text =
      fmt::format("Opacity {:.4g}, exact {:.4g}. {} samples; of {} crossings {} missed",
                  ray.steps.back().color.a, exact, ray.steps.size() - 1, ray.crossings.exact.size(), missed);
  if (ray.crossings.invented > 0) text += fmt::format(", {} invented", ray.crossings.invented);
  return text;
}

void legend_entry(const char* text, ImU32 color) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float side = ImGui::GetFontSize(), middle = at.y + side / 2;
  ImGui::GetWindowDrawList()->AddLine({at.x, middle}, {at.x + side, middle}, color, 2);
  ImGui::Dummy({side, side});
  ImGui::SameLine(0, scaled(4));
  ImGui::TextDisabled("%s", text);
  ImGui::SameLine(0, scaled(12));
}

/// Zooms and pans the axis of depths with the mouse over the plots.
void move_axis(RayState& state, const ValueAxis& axis, ValueRange whole) {
  const ImGuiIO& io = ImGui::GetIO();
  if (!ImGui::IsItemHovered() && !ImGui::IsItemActive()) return;
  if (ImGui::IsItemHovered()) ImGui::SetItemUsingMouseWheel();
  if (ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) return state.visible.reset();
  if (io.MouseWheel != 0 && ImGui::IsItemHovered())
    state.visible = zoom(axis.visible, whole, axis.value_at(double(io.MousePos.x)),
                         std::pow(zoom_per_notch, double(io.MouseWheel)));
  if (ImGui::IsItemActive() && io.MouseDelta.x != 0)
    state.visible = pan(axis.visible, whole, -double(io.MouseDelta.x) * axis.value_per_pixel());
}

void readout(StudioState& state, const InspectedRay& ray, double depth) {
  const double value = ray.exact.value_at(depth);
  std::string text = fmt::format("depth {}   value {}\nexact opacity {:.4g}", short_text(depth),
                                 short_text(value), ray.exact.opacity_at(depth));
  const auto behind = std::ranges::upper_bound(ray.steps, depth, {}, &TracedStep::depth);
  if (behind != ray.steps.begin()) text += fmt::format("   as drawn {:.4g}", std::prev(behind)->color.a);
  state.under_cursor = text;
}

void plots(StudioState& state, const StudioInputs& inputs, const InspectedRay& ray) {
  const ImVec2 corner = ImGui::GetCursorScreenPos(), room = ImGui::GetContentRegionAvail();
  const ImVec2 size{room.x, room.y};
  if (size.x < scaled(120) || size.y < scaled(90)) return;
  const ValueRange whole{ray.exact.enter, ray.exact.exit};
  if (!(whole.width() > 0)) return;
  if (state.ray.visible) state.ray.visible = pan(*state.ray.visible, whole, 0);
  const double gutter = double(scaled(58));
  const ValueAxis axis{state.ray.visible.value_or(whole), double(corner.x) + gutter,
                       double(size.x) - gutter - double(scaled(6))};
  ImGui::InvisibleButton("##ray plots", size);
  note_item(state.widgets, "ray plots");
  move_axis(state.ray, axis, whole);
  draw_ray_plots(ray, inputs.surfaces, axis, corner, size);
  const double x = double(ImGui::GetIO().MousePos.x);
  if (ImGui::IsItemHovered() && x >= axis.left && x <= axis.left + axis.pixels) {
    ImGui::GetWindowDrawList()->AddLine({float(x), corner.y}, {float(x), corner.y + size.y}, palette().grid);
    readout(state, ray, axis.value_at(x));
    const float width = ImGui::CalcTextSize(state.under_cursor.c_str()).x, gap = scaled(16);
    const float right = corner.x + size.x - width - scaled(6);
    text_on_picture(*ImGui::GetWindowDrawList(),
                    {std::max(corner.x, std::min(float(x) + gap, right)), ImGui::GetIO().MousePos.y + gap},
                    state.under_cursor);
  }
}

}  // namespace

void ray_panel(const Document& document, StudioState& state, const StudioInputs& inputs) {
  if (!state.ray.ask || !inputs.volume) {
    ImGui::TextUnformatted(inputs.volume ? "No ray yet." : "No volume is open.");
    ImGui::PushTextWrapPos();
    ImGui::TextDisabled("%s", inputs.volume
                                  ? "Click a pixel in a view: its ray is shown with the samples taken, the "
                                    "surfaces met and missed, and the opacity that builds up."
                                  : "Volume > Open volume... (Ctrl+O), or drop a file here.");
    ImGui::PopTextWrapPos();
    return;
  }
  mode_buttons(state);
  const std::size_t index = std::size_t(std::ranges::find(view_modes, state.ray.mode) - view_modes.begin());
  const bool is_there = inputs.ray && inputs.ray->modes[index];
  if (!is_there) {
    const std::string error = inputs.ray ? inputs.ray->errors[index] : "";
    const std::string text = error.empty() ? "Solving the ray ..." : "The ray could not be solved: " + error;
    ImGui::PushTextWrapPos();
    ImGui::TextDisabled("%s", text.c_str());
    ImGui::PopTextWrapPos();
    return note_item(state.widgets, "ray: " + text);
  }
  const InspectedRay& ray = *inputs.ray->modes[index];
  if (ray.exact.places.empty())
    return ImGui::TextDisabled("This ray misses the volume: click one that meets it.");
  ImGui::PushTextWrapPos();
  ImGui::TextUnformatted(summary(ray).c_str());
  ImGui::PopTextWrapPos();
  note_item(state.widgets, "ray: " + summary(ray));
  legend_entry("exact", palette().curve);
  legend_entry("as the settings have it", palette().accent);
  legend_entry("missed", palette().error);
  if (ImGui::SmallButton("Save as CSV...")) ask_for_file(state, document, FilePurpose::save_ray);
  note_item(state.widgets, "save ray");
  plots(state, inputs, ray);
}

}  // namespace crest
