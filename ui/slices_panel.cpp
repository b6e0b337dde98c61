#include "ui/slices_panel.h"

#include <fmt/core.h>
#include <imgui_internal.h>

#include <algorithm>
#include <cmath>

#include "render/volume/orientation.h"
#include "render/volume/probe.h"
#include "ui/edit_points.h"
#include "ui/edit_shown.h"
#include "ui/plot.h"
#include "ui/point_tools.h"
#include "ui/style.h"
#include "ui/transfer_function_editor.h"
#include "ui/widgets.h"

namespace crest {
namespace {

constexpr const char* axis_names[] = {"x", "y", "z"};
constexpr std::array<int, slice_count> order{2, 1, 0};  // the axial one first

/// Of the slice across an axis: "Axial, "; empty where nothing is known of a patient.
const char* anatomical_name(const Volume& volume, int axis) {
  const auto patient = anatomical_axes(volume);
  if (!patient) return "";
  const char from = (*patient)[std::size_t(axis)].from;
  return from == 'R' || from == 'L' ? "Sagittal, " : from == 'A' || from == 'P' ? "Coronal, " : "Axial, ";
}

/// Where left and right, front and back, head and feet are, at the sides of a slice.
void draw_sides(ImDrawList& list, ImVec2 low, ImVec2 size, const Volume& volume, int axis) {
  const auto patient = anatomical_axes(volume);
  if (!patient) return;
  const glm::ivec2 axes = slice_axes(axis);
  const AxisEnds right = (*patient)[std::size_t(axes.x)], up = (*patient)[std::size_t(axes.y)];
  const ImVec2 middle{low.x + size.x / 2, low.y + size.y / 2};
  const float inset = 0.7F * ImGui::GetFontSize();
  const auto write = [&](char letter, ImVec2 at) {
    const char text[2] = {letter, 0};
    const ImVec2 half = ImGui::CalcTextSize(text);
    list.AddText({at.x - half.x / 2 + 1, at.y - half.y / 2 + 1}, IM_COL32_BLACK, text);
    list.AddText({at.x - half.x / 2, at.y - half.y / 2}, IM_COL32_WHITE, text);
  };
  write(right.from, {low.x + inset, middle.y});
  write(right.to, {low.x + size.x - inset, middle.y});
  write(up.to, {middle.x, low.y + inset});
  write(up.from, {middle.x, low.y + size.y - inset});
}

/// The largest rectangle of the slice's shape in `room`.
ImVec2 fitted_in(ImVec2 room, const Grid& grid, int axis) {
  const glm::ivec2 axes = slice_axes(axis);
  const double width = grid.box_size()[axes.x], height = grid.box_size()[axes.y];
  const double scale = std::min(double(room.x) / width, double(room.y) / height);
  return {std::max(std::floor(float(width * scale)), 1.0F),
          std::max(std::floor(float(height * scale)), 1.0F)};
}

/// Turns of the wheel go from point to point.
void step_along(glm::dvec3& cursor, const Grid& grid, int axis, double notches) {
  const double last = grid.dims[axis] - 1;
  cursor[axis] = std::clamp((std::round(cursor[axis] * last) + notches) / last, 0.0, 1.0);
}

void draw_cross(ImDrawList& list, ImVec2 low, ImVec2 size, const glm::dvec3& cursor, int axis) {
  const glm::ivec2 axes = slice_axes(axis);
  const float x = low.x + float(cursor[axes.x]) * size.x, y = low.y + float(1 - cursor[axes.y]) * size.y;
  const float gap = scaled(5);
  const ImU32 color = palette().accent;
  list.AddLine({low.x, y}, {std::max(x - gap, low.x), y}, color);
  list.AddLine({std::min(x + gap, low.x + size.x), y}, {low.x + size.x, y}, color);
  list.AddLine({x, low.y}, {x, std::max(y - gap, low.y)}, color);
  list.AddLine({x, std::min(y + gap, low.y + size.y)}, {x, low.y + size.y}, color);
}

void slice_view(StudioState& state, const StudioInputs& inputs, SlicesWanted& wanted, int axis, ImVec2 room) {
  const Grid& grid = inputs.volume->grid;
  glm::dvec3& cursor = state.slice_cursor;
  const double place = grid.origin[axis] + cursor[axis] * grid.box_size()[axis];
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  ImGui::TextDisabled("%s%s = %s", anatomical_name(*inputs.volume, axis), axis_names[axis],
                      short_text(place).c_str());
  room.y -= ImGui::GetCursorScreenPos().y - corner.y;
  const ImVec2 size = fitted_in({std::max(room.x, 8.0F), std::max(room.y, 8.0F)}, grid, axis);
  wanted.pixels[std::size_t(axis)] = {int(size.x), int(size.y)};
  const ImVec2 low = ImGui::GetCursorScreenPos();
  const std::string name = fmt::format("slice/{}", axis_names[axis]);
  ImGui::InvisibleButton(name.c_str(), size);
  note_item(state.widgets, name);
  const ImGuiIO& io = ImGui::GetIO();
  if (ImGui::IsItemActive()) {
    const glm::dvec2 at{(io.MousePos.x - low.x) / size.x, (io.MousePos.y - low.y) / size.y};
    cursor = place_in_box({axis, cursor[axis]}, glm::clamp(at, 0.0, 1.0));
  }
  if (ImGui::IsItemHovered()) {
    ImGui::SetItemUsingMouseWheel();
    if (io.MouseWheel != 0) step_along(cursor, grid, axis, double(io.MouseWheel));
  }
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 high{low.x + size.x, low.y + size.y};
  if (const std::uintptr_t texture = inputs.slices[std::size_t(axis)])
    list.AddImage(reinterpret_cast<ImTextureID>(texture), low, high);
  draw_cross(list, low, size, cursor, axis);
  draw_sides(list, low, size, *inputs.volume, axis);
  list.AddRect(low, high, palette().frame);
}

bool probe(Document& document, StudioState& state, const StudioInputs& inputs) {
  const Volume& volume = *inputs.volume;
  const glm::dvec3 cursor = state.slice_cursor, box = volume.grid.box_size();
  const glm::dvec3 at = volume.grid.origin + cursor * box, voxel = cursor * glm::dvec3(volume.grid.dims - 1);
  const auto value = value_at(volume, dvr_filter(document.preset.rendering), cursor);
  ImGui::Text("%s", value ? fmt::format("value {}", short_text(*value)).c_str() : "no value here");
  note_item(state.widgets, "slice value");
  if (value) {
    const Classified found = evaluate(inputs.resolved, *value);
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const float side = ImGui::GetFontSize();
    ImGui::GetWindowDrawList()->AddRectFilled(low, {low.x + side, low.y + side}, packed(found.color));
    ImGui::SetCursorScreenPos({low.x + side + scaled(6), low.y});
    ImGui::TextDisabled("opacity %.4g", found.opacity);
  }
  ImGui::TextDisabled("at %s, %s, %s", short_text(at.x).c_str(), short_text(at.y).c_str(),
                      short_text(at.z).c_str());
  ImGui::TextDisabled("voxel %.4g, %.4g, %.4g", voxel.x, voxel.y, voxel.z);
  bool changed = false;
  if (value && ImGui::Button("Add a spike here")) {
    TransferFunction& tf = document.preset.transfer_function;
    changed = in_shown_values(document, state, inputs, [&] {
      const ValueRange axis = axis_range(tf, inputs.volume);
      const double on_axis = data_to_domain(tf, volume.statistics.range)(*value);
      return add_shape(tf, state.editor, Shape::spike, round_to_resolution(on_axis, 1e-4 * axis.width()), 0.8,
                       axis);
    });
  }
  if (value) {
    note_item(state.widgets, "add spike here");
    tip("A spike at the cursor's value");
  }
  ImGui::TextDisabled("Drag the cursor, turn the wheel");
  return changed;
}

}  // namespace

bool slices_panel(Document& document, StudioState& state, const StudioInputs& inputs,
                  StudioRequests& requests) {
  if (!inputs.volume) {
    ImGui::TextDisabled("No volume is open: Volume > Open volume... (Ctrl+O), or drop a file here.");
    return false;
  }
  const ImVec2 corner = ImGui::GetCursorScreenPos(), room = ImGui::GetContentRegionAvail();
  const float gap = scaled(8);
  const ImVec2 cell{std::floor((room.x - gap) / 2), std::floor((room.y - gap) / 2)};
  SlicesWanted wanted;
  bool changed = false;
  for (int i = 0; i < 4; ++i) {
    ImGui::SetCursorScreenPos(
        {corner.x + float(i % 2) * (cell.x + gap), corner.y + float(i / 2) * (cell.y + gap)});
    ImGui::BeginGroup();
    if (i < slice_count)
      slice_view(state, inputs, wanted, order[std::size_t(i)], cell);
    else
      changed |= probe(document, state, inputs);
    ImGui::EndGroup();
  }
  wanted.cursor = state.slice_cursor;
  requests.slices = wanted;
  return changed;
}

}  // namespace crest
