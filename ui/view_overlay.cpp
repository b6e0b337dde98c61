#include "ui/view_overlay.h"

#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "render/volume/orientation.h"
#include "ui/camera_control.h"

namespace crest {
namespace {

constexpr ImU32 edge_color = IM_COL32(150, 158, 170, 70);
constexpr ImU32 axis_colors[3] = {IM_COL32(236, 120, 60, 230), IM_COL32(60, 190, 150, 230),
                                  IM_COL32(110, 176, 240, 230)};
constexpr const char* axis_names[3] = {"x", "y", "z"};

bool is_sane(ImVec2 p) { return std::abs(p.x) < 1e6F && std::abs(p.y) < 1e6F; }

}  // namespace

void draw_outline(ImDrawList& list, const Camera& camera, const Volume& volume, ImVec2 low, ImVec2 size) {
  const Grid& grid = volume.grid;
  const glm::dvec3 corners[2] = {grid.box_min(), grid.box_max()};
  const auto corner = [&](int bits) {
    return glm::dvec3(corners[bits & 1].x, corners[bits >> 1 & 1].y, corners[bits >> 2 & 1].z);
  };
  const auto pixel = [&](glm::dvec2 p) {
    return ImVec2(low.x + size.x * float(p.x + 1) / 2, low.y + size.y * float(1 - p.y) / 2);
  };
  const auto line = [&](glm::dvec3 from, glm::dvec3 to, ImU32 color,
                        float width) -> std::optional<std::pair<ImVec2, ImVec2>> {
    const auto ends = project_segment(camera, double(size.x / size.y), from, to);
    if (!ends) return std::nullopt;
    const ImVec2 a = pixel(ends->first), b = pixel(ends->second);
    if (!is_sane(a) || !is_sane(b)) return std::nullopt;
    list.AddLine(a, b, color, width);
    return {{a, b}};
  };
  for (int from = 1; from < 8; ++from)  // the edges at corner 0 are the axes
    for (int axis = 0; axis < 3; ++axis)
      if (!(from >> axis & 1)) line(corner(from), corner(from | 1 << axis), edge_color, 1);
  const auto patient = anatomical_axes(volume);
  for (int axis = 0; axis < 3; ++axis) {
    const auto ends = line(corner(0), corner(1 << axis), axis_colors[axis], 1.5F);
    if (!ends) continue;
    const auto write = [&](ImVec2 at, const std::string& text) {
      list.AddText({at.x + 4, at.y - ImGui::GetFontSize() / 2}, axis_colors[axis], text.c_str());
    };
    if (!patient) {
      write(ends->second, axis_names[axis]);
      continue;
    }
    // At its beginning the three axes meet: each a little way along
    constexpr float share = 0.12F;
    const auto [a, b] = *ends;
    write({a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)}, {(*patient)[std::size_t(axis)].from});
    write(b, {(*patient)[std::size_t(axis)].to});
  }
}

}  // namespace crest
