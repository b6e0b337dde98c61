#include "ui/part_form.h"

#include <fmt/core.h>

#include <algorithm>
#include <limits>

#include "ui/number_field.h"
#include "ui/style.h"

namespace crest {
namespace {

constexpr float field_width = 84;

GridPart part_of(const OpeningState& opening, const OpenChoice& choice) {
  GridPart part = choice.need->part;
  if (!opening.takes_box) return at_stride(part, std::uint64_t(opening.stride));
  part.first = glm::u64vec3(opening.box_first);
  part.end = glm::u64vec3(opening.box_end);
  return part;
}

MemoryNeed need_of(const OpeningState& opening, const OpenChoice& choice) {
  MemoryNeed need = *choice.need;
  need.part = part_of(opening, choice);
  return need;
}

bool fits(const MemoryNeed& need, std::uint64_t memory) {
  const auto bytes = bytes_of(need);
  return bytes && *bytes <= memory;
}

/// Why what is chosen is no volume; or empty.
std::string fault_of(const GridPart& part) {
  for (int axis = 0; axis < 3; ++axis) {
    if (part.first[axis] >= part.end[axis])
      return fmt::format("On {} the box ends where it begins, or before", "xyz"[axis]);
    if (part.dims()[axis] < 2) return fmt::format("One point is left on {}, and a volume has 2", "xyz"[axis]);
  }
  return {};
}

std::string size_text(const MemoryNeed& need) {
  const glm::u64vec3 dims = need.part.dims();
  const auto bytes = bytes_of(need);
  return fmt::format("{} x {} x {} points, {}", dims.x, dims.y, dims.z,
                     bytes ? byte_text(*bytes) : "more than can be counted");
}

void radio(StudioState& state, const char* text, bool is_box) {
  if (ImGui::RadioButton(text, state.opening.takes_box == is_box)) state.opening.takes_box = is_box;
  note_item(state.widgets, is_box ? "part box" : "part stride");
}

void stride_field(StudioState& state) {
  OpeningState& opening = state.opening;
  radio(state, "Every n-th point on each axis, n =", false);
  ImGui::SameLine();
  if (integer_field(state.widgets, "##stride", opening.stride, 1, 1 << 20, scaled(field_width)))
    opening.takes_box = false;
}

void box_fields(StudioState& state, const GridPart& whole) {
  OpeningState& opening = state.opening;
  radio(state, "A box, from a point to the one behind its last", true);
  constexpr const char* first[] = {"##box x0", "##box y0", "##box z0"};
  constexpr const char* end[] = {"##box x1", "##box y1", "##box z1"};
  for (int axis = 0; axis < 3; ++axis) {
    const int most =
        int(std::min<std::uint64_t>(whole.full[axis], std::uint64_t(std::numeric_limits<int>::max())));
    ImGui::Dummy({scaled(16), 0});
    ImGui::SameLine();
    field_label(axis == 0 ? "x" : axis == 1 ? "y" : "z");
    ImGui::SameLine();
    bool changed =
        integer_field(state.widgets, first[axis], opening.box_first[axis], 0, most, scaled(field_width));
    ImGui::SameLine();
    field_label("to");
    ImGui::SameLine();
    changed |= integer_field(state.widgets, end[axis], opening.box_end[axis], 0, most, scaled(field_width));
    if (changed) opening.takes_box = true;
    ImGui::SameLine();
    ImGui::TextDisabled("of %d", most);
  }
}

/// In the middle of what was asked for, halved until it fits.
void take_middle(OpeningState& opening, const OpenChoice& choice) {
  GridPart box = choice.need->part;
  MemoryNeed need = *choice.need;
  while (!fits(need, choice.memory) && glm::any(glm::greaterThan(box.end - box.first, glm::u64vec3(3)))) {
    for (int axis = 0; axis < 3; ++axis) {
      const std::uint64_t size = box.end[axis] - box.first[axis];
      if (size <= 3) continue;
      box.first[axis] += size / 4;
      box.end[axis] = box.first[axis] + (size + 1) / 2;
    }
    need.part = box;
  }
  opening.box_first = glm::ivec3(box.first);
  opening.box_end = glm::ivec3(box.end);
}

}  // namespace

void begin_part_form(OpeningState& opening, const OpenChoice& choice) {
  const auto part = part_that_fits(*choice.need, choice.memory);
  const glm::u64vec3 stride = part ? part->stride : glm::u64vec3(2);
  opening.takes_box = !part;
  opening.stride = int(std::max({stride.x, stride.y, stride.z}));
  take_middle(opening, choice);
}

bool part_form(StudioState& state, const OpenChoice& choice) {
  MemoryNeed all = *choice.need;
  ImGui::TextUnformatted(
      fmt::format("It has {}, and {} are free.", size_text(all), byte_text(choice.memory)).c_str());
  ImGui::TextDisabled("Points are left out, not averaged: values stay, and thin things may be lost.");
  ImGui::Spacing();
  stride_field(state);
  box_fields(state, choice.need->part);
  ImGui::Spacing();
  const MemoryNeed need = need_of(state.opening, choice);
  const std::string fault = fault_of(need.part);
  const bool can_open = fault.empty() && fits(need, choice.memory);
  ImGui::PushStyleColor(ImGuiCol_Text, can_open ? palette().good : palette().warning);
  ImGui::TextUnformatted(
      (fault.empty() ? size_text(need) + (can_open ? ": it fits" : ": too large") : fault).c_str());
  ImGui::PopStyleColor();
  note_item(state.widgets, can_open ? "part fits" : "part refused");
  return can_open;
}

std::string source_with_part(const OpeningState& opening, const OpenChoice& choice) {
  return source_of(choice.path, with_part(choice.query, part_of(opening, choice)));
}

}  // namespace crest
