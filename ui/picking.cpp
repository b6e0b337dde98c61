#include "ui/picking.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "ui/edit_shown.h"
#include "ui/plot.h"
#include "ui/point_tools.h"
#include "ui/style.h"
#include "ui/transfer_function_editor.h"

namespace crest {
namespace {

constexpr float still = 3;  // pixels: a press that goes no further is a click
constexpr double picked_opacity = 0.8;

bool is_click(ImGuiMouseButton button) {
  return ImGui::IsMouseReleased(button) &&
         ImGui::GetIO().MouseDragMaxDistanceSqr[button] <= scaled(still) * scaled(still);
}

glm::ivec2 pixel_at(ImVec2 mouse, ImVec2 low, ImVec2 size, glm::ivec2 pixels) {
  const auto along = [](float share, int count) {
    return std::clamp(int(share * float(count)), 0, count - 1);
  };
  return {along((mouse.x - low.x) / size.x, pixels.x), along((mouse.y - low.y) / size.y, pixels.y)};
}

/// The value that shows most, where it is another than the first surface's.
std::optional<double> other_value(const Picked& picked, const Volume& volume) {
  const double alike = 1e-3 * volume.statistics.range.width();
  if (picked.surface && picked.strongest && std::abs(*picked.strongest - *picked.surface) <= alike) return {};
  return picked.strongest;
}

std::string readout(const Picked& picked, const Volume& volume) {
  std::string text;
  if (picked.surface)
    text =
        fmt::format("surface {}   depth {}", short_text(*picked.surface), short_text(*picked.surface_depth));
  if (const auto other = other_value(picked, volume))
    text += fmt::format("{}most from {} ({:.0f} %)", text.empty() ? "" : "\n", short_text(*other),
                        100 * picked.strongest_share);
  return text;
}

void draw_readout(const std::string& text, ImVec2 low, ImVec2 size) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 extent = ImGui::CalcTextSize(text.c_str()), mouse = ImGui::GetIO().MousePos;
  const float gap = scaled(14), pad = scaled(4);
  const ImVec2 at{std::min(mouse.x + gap, low.x + size.x - extent.x - 2 * pad),
                  std::min(mouse.y + gap, low.y + size.y - extent.y - 2 * pad)};
  text_on_picture(list, at, text);
}

/// Where the ray is that is inspected.
void draw_mark(const RayAsk& ask, ImVec2 low, ImVec2 size) {
  // Another view may have another width: from the middle, in shares of the height
  const float x = (float(ask.pixel.x) + 0.5F - float(ask.size.x) / 2) / float(ask.size.y),
              y = (float(ask.pixel.y) + 0.5F) / float(ask.size.y);
  const ImVec2 at{low.x + size.x / 2 + x * size.y, low.y + y * size.y};
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.PushClipRect(low, {low.x + size.x, low.y + size.y}, true);
  list.AddCircle(at, scaled(6), IM_COL32(0, 0, 0, 180), 0, 3);
  list.AddCircle(at, scaled(6), palette().accent, 0, 1.5F);
  list.PopClipRect();
}

/// Selects the peak whose surface it is.
void select_item(StudioState& state, const StudioInputs& inputs, double surface) {
  const auto away = [&](const Peak& peak) { return std::abs(peak.value - surface); };
  const auto peak = std::ranges::min_element(inputs.surfaces, {}, away);
  if (peak == inputs.surfaces.end()) return;
  if (ImGui::MenuItem(fmt::format("Select the peak of this surface, {}", short_text(surface)).c_str())) {
    state.editor.selection.clear();
    for (std::size_t i = peak->first_point; i <= peak->last_point; ++i) state.editor.selection.push_back(i);
  }
  note_item(state.widgets, "select peak");
}

/// Adds a peak at a value of the volume, and selects it.
bool peak_item(Document& document, StudioState& state, const StudioInputs& inputs, double value) {
  const bool chosen =
      ImGui::MenuItem(fmt::format("Make a peak of {}, which shows most", short_text(value)).c_str());
  note_item(state.widgets, "make peak");
  if (!chosen) return false;
  TransferFunction& tf = document.preset.transfer_function;
  return in_shown_values(document, state, inputs, [&] {
    const double in_domain = data_to_domain(tf, inputs.volume->statistics.range)(value);
    const ValueRange visible = state.editor.visible.value_or(axis_range(tf, inputs.volume));
    return add_shape(tf, state.editor, Shape::spike, in_domain, picked_opacity, visible);
  });
}

void inspect(StudioState& studio, const RayAsk& ask, Mode mode) {
  RayState& state = studio.ray;
  state.ask = ask;
  state.mode = mode;
  state.visible.reset();
  studio.asked_tab = "Ray";
}

/// A click that is not the first of two, which enlarge the view: known when the time for the second is over.
void inspect_clicked(StudioState& state, const RayAsk& here, Mode mode) {
  const ImGuiIO& io = ImGui::GetIO();
  if (is_click(ImGuiMouseButton_Left) && ImGui::IsItemDeactivated() && io.MouseClickedLastCount[0] < 2)
    state.ray.clicked = ClickedPixel{here, mode, ImGui::GetTime()};
}

bool pick_menu(Document& document, StudioState& state, const StudioInputs& inputs, const RayAsk& here,
               Mode mode) {
  if (!ImGui::BeginPopup("pick")) return false;
  bool changed = false;
  const Picked& picked = state.ray.picked;
  if (picked.surface) select_item(state, inputs, *picked.surface);
  if (const auto other = other_value(picked, *inputs.volume))
    changed |= peak_item(document, state, inputs, *other);
  if (!picked.surface && !picked.strongest) ImGui::TextDisabled("Nothing shows here");
  ImGui::Separator();
  if (ImGui::MenuItem("Inspect the ray")) inspect(state, here, mode);
  note_item(state.widgets, "inspect ray");
  ImGui::EndPopup();
  return changed;
}

}  // namespace

bool pick_in_view(Document& document, StudioState& state, const StudioInputs& inputs,
                  StudioRequests& requests, int view, ImVec2 low, ImVec2 size, glm::ivec2 pixels) {
  if (!inputs.volume) return false;
  const Mode mode = state.views.contents[std::size_t(view)].mode;
  const ImGuiIO& io = ImGui::GetIO();
  const RayAsk here{view, pixel_at(io.MousePos, low, size, pixels), pixels};
  if (ImGui::IsItemHovered() && !state.views.moves_divider) {
    requests.hovered = here;
    const bool is_known = inputs.picked && inputs.picked->ask == here;
    inspect_clicked(state, here, mode);
    if (is_click(ImGuiMouseButton_Right)) {
      state.ray.picked = is_known ? inputs.picked->picked : Picked{};
      state.ray.under_menu = here;
      ImGui::OpenPopup("pick");
    }
    if (is_known && !ImGui::IsAnyMouseDown())
      if (const std::string text = readout(inputs.picked->picked, *inputs.volume); !text.empty()) {
        draw_readout(text, low, size);
        state.under_cursor = text;
        std::ranges::replace(state.under_cursor, '\n', ' ');
      }
  }
  if (auto& clicked = state.ray.clicked) {
    requests.animates = true;
    if (io.MouseDown[0] || state.views.moves_divider)
      clicked.reset();
    else if (ImGui::GetTime() - clicked->time > double(io.MouseDoubleClickTime)) {
      inspect(state, clicked->ask, clicked->mode);
      clicked.reset();
    }
  }
  if (state.ray.ask) draw_mark(*state.ray.ask, low, size);
  return pick_menu(document, state, inputs, state.ray.under_menu, mode);
}

}  // namespace crest
