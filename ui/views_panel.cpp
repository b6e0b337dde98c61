#include "ui/views_panel.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "render/scene/camera.h"
#include "render/scene/error_colors.h"
#include "ui/camera_control.h"
#include "ui/comparison_view.h"
#include "ui/keys.h"
#include "ui/picking.h"
#include "ui/questions.h"
#include "ui/style.h"
#include "ui/view_caption.h"
#include "ui/view_overlay.h"

namespace crest {
namespace {

constexpr double turn_per_pixel = 0.008;  // radians
constexpr double dolly_per_notch = 0.88;
constexpr float least_view = 24;  // pixels

/// What the colours of an error bound mean.
void error_legend(ImDrawList& list, ImVec2 at) {
  const auto colors = error_scale();
  const float width = scaled(12), height = scaled(8);
  for (const glm::vec3 color : colors) {
    list.AddRectFilled(at, {at.x + width, at.y + height},
                       ImGui::ColorConvertFloat4ToU32({color.r, color.g, color.b, 1}));
    at.x += width;
  }
  const std::string text = fmt::format("off by at most {:g} .. {:g}", least_shown_error, most_shown_error);
  text_on_picture(list, {at.x + scaled(10), at.y + (height - ImGui::GetFontSize()) / 2}, text);
}

/// Moves the camera in force as the mouse says.
bool move_camera(Document& document, StudioState& state, const Grid& grid, const Camera& before,
                 float height) {
  const ImGuiIO& io = ImGui::GetIO();
  Camera camera = before;
  const glm::dvec2 shift(io.MouseDelta.x, io.MouseDelta.y);
  if (ImGui::IsItemActive() && shift != glm::dvec2(0)) {
    if (ImGui::IsMouseDown(ImGuiMouseButton_Left) && !io.KeyShift)
      camera = orbit(camera, -shift.x * turn_per_pixel, shift.y * turn_per_pixel);
    else
      camera = pan(camera, glm::dvec2(shift.x, -shift.y) / double(height));
  }
  if (ImGui::IsItemHovered() && io.MouseWheel != 0) {
    const double size = glm::length(grid.box_size());
    camera = dolly(camera, std::pow(dolly_per_notch, double(io.MouseWheel)), size * 1e-4, size * 1e3);
    state.camera_moved = ImGui::GetTime();
  }
  if (camera == before) return false;
  document.preset.camera = camera;
  return true;
}

/// With the focus on a view, arrows turn, with Shift they move the picture, and the page keys come nearer.
bool move_camera_by_keys(Document& document, StudioState& state, const Grid& grid, const Camera& before) {
  constexpr double turn = std::numbers::pi / 36, shift = 0.05;
  const auto pressed = [](int code) { return int(ImGui::IsKeyPressed(code)); };
  const double across = pressed(key::right) - pressed(key::left), up = pressed(key::up) - pressed(key::down);
  const double notches = pressed(key::page_up) - pressed(key::page_down);
  Camera camera = before;
  if (across != 0 || up != 0)
    camera = ImGui::GetIO().KeyShift ? pan(camera, glm::dvec2(across, up) * shift)
                                     : orbit(camera, across * turn, up * turn);
  if (notches != 0) {
    const double size = glm::length(grid.box_size());
    camera = dolly(camera, std::pow(dolly_per_notch, notches), size * 1e-4, size * 1e3);
  }
  if (camera == before) return false;
  document.preset.camera = camera;
  state.camera_moved = ImGui::GetTime();
  return true;
}

void picture(int index, StudioState& state, const StudioInputs& inputs, const Camera& camera, ImVec2 low,
             ImVec2 size) {
  const ViewPicture& view = inputs.views[std::size_t(index)];
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 high{low.x + size.x, low.y + size.y};
  if (compares_view(state.views, index) && draw_comparison(state, inputs, low, size)) {
  } else if (view.texture != 0)
    list.AddImage(reinterpret_cast<ImTextureID>(view.texture), low, high);
  else
    list.AddRectFilled(low, high, palette().plot);
  list.PushClipRect(low, high, true);
  if (inputs.volume && state.views.outline) draw_outline(list, camera, *inputs.volume, low, size);
  if (!inputs.volume) {
    const char* hint =
        inputs.loading.empty() ? "Volume > Open, or drop a file here" : "Reading the volume ...";
    const ImVec2 text = ImGui::CalcTextSize(hint);
    list.AddText({low.x + (size.x - text.x) / 2, low.y + (size.y - text.y) / 2}, palette().secondary, hint);
  }
  if (view.texture != 0 && (view.coarseness > 1 || view.progress < 1)) {
    const std::string hint = view.coarseness > 1 ? fmt::format("coarse 1:{}", view.coarseness)
                             : view.is_exact     ? fmt::format("exact: {:.0f} %", 100 * view.progress)
                                                 : "refining";
    text_on_picture(list, {low.x + scaled(10), high.y - ImGui::GetFontSize() - scaled(10)}, hint);
    const float done = size.x * float(std::clamp(view.progress, 0.0, 1.0));
    list.AddRectFilled({low.x, high.y - scaled(2)}, {low.x + done, high.y}, palette().accent);
  }
  const ShownPicture shown =
      state.views.contents[std::size_t(index)].picture.value_or(shown_by_all(state.views));
  if (shown == ShownPicture::error_bound && view.is_exact)
    error_legend(list, {low.x + scaled(8), low.y + scaled(8)});
  list.PopClipRect();
}

/// Where the mouse is in a picture: from its middle and its top, as shares of its height. In pictures of any
/// width that is the same ray.
glm::vec2 cursor_at(ImVec2 mouse, ImVec2 low, ImVec2 size) {
  return {(mouse.x - low.x - size.x / 2) / size.y, (mouse.y - low.y) / size.y};
}

/// The mouse in another view.
void cursor_mark(ImDrawList& list, glm::vec2 cursor, ImVec2 low, ImVec2 size) {
  const ImVec2 at{low.x + size.x / 2 + cursor.x * size.y, low.y + cursor.y * size.y};
  const float inner = scaled(4), outer = scaled(11);
  list.PushClipRect(low, {low.x + size.x, low.y + size.y}, true);
  for (const auto& [color, width] : {std::pair{IM_COL32(0, 0, 0, 160), 3.0F}, {IM_COL32_WHITE, 1.0F}})
    for (const float way : {-1.0F, 1.0F}) {
      list.AddLine({at.x + way * inner, at.y}, {at.x + way * outer, at.y}, color, width);
      list.AddLine({at.x, at.y + way * inner}, {at.x, at.y + way * outer}, color, width);
    }
  list.PopClipRect();
}

bool view(Document& document, StudioState& state, const StudioInputs& inputs, StudioRequests& requests,
          int index, ImVec2 corner, ImVec2 size, std::optional<glm::vec2>& cursor) {
  const std::size_t i = std::size_t(index);
  ImGui::PushID(index);
  ImGui::SetCursorScreenPos(corner);
  ImGui::BeginChild(
      "view", size, false,
      ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse | ImGuiWindowFlags_NavFlattened);
  view_caption(index, state, inputs, document.preset);
  bool changed = false;
  const ImVec2 low = ImGui::GetCursorScreenPos(), room = ImGui::GetContentRegionAvail();
  const ImVec2 image{std::floor(room.x), std::floor(room.y)};
  if (image.x >= least_view && image.y >= least_view) {
    const ImVec2 pixel = ImGui::GetIO().DisplayFramebufferScale;
    requests.view_pixels[i] = {int(image.x * std::max(pixel.x, 1.0F)),
                               int(image.y * std::max(pixel.y, 1.0F))};
    ImGui::InvisibleButton("##picture", image,
                           ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight |
                               ImGuiButtonFlags_MouseButtonMiddle);
    note_item(state.widgets, fmt::format("view{}", index));
    take_focus(state.navigation, Area::views);
    const ImGuiID id = ImGui::GetID("##picture");
    const bool has_arrows = takes_arrows(state.navigation);
    Camera camera;
    if (inputs.volume) camera = camera_of(document.preset, inputs.volume->grid, double(image.x / image.y));
    if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left))
      state.views.enlarged = state.views.enlarged == index ? -1 : index;
    else if (compares_view(state.views, index) &&
             move_divider(state.views, ImGui::IsItemHovered(), ImGui::IsItemActive(), low, image))
      changed = false;
    else if (inputs.volume)
      changed = move_camera(document, state, inputs.volume->grid, camera, image.y) ||
                (has_arrows && move_camera_by_keys(document, state, inputs.volume->grid, camera));
    picture(index, state, inputs, document.preset.camera.value_or(camera), low, image);
    show_focus(id, low, {low.x + image.x, low.y + image.y});
    const bool is_hovered = ImGui::IsItemHovered();
    changed |= pick_in_view(document, state, inputs, requests, index, low, image, requests.view_pixels[i]);
    if (is_hovered) {
      cursor = cursor_at(ImGui::GetIO().MousePos, low, image);
    } else if (state.views.cursor) {
      cursor_mark(*ImGui::GetWindowDrawList(), *state.views.cursor, low, image);
    }
  }
  ImGui::EndChild();
  ImGui::PopID();
  return changed;
}

/// Where the n views of the grid are: beside each other, two in a row, the last of an odd number as wide as
/// its row.
std::vector<std::pair<ImVec2, ImVec2>> grid_places(int count, ImVec2 corner, ImVec2 room) {
  const float gap = scaled(8);
  const int columns = count == 1 ? 1 : 2, rows = (count + 1) / 2;
  const ImVec2 size{std::floor((room.x - gap * float(columns - 1)) / float(columns)),
                    std::floor((room.y - gap * float(rows - 1)) / float(rows))};
  std::vector<std::pair<ImVec2, ImVec2>> places;
  for (int i = 0; i < count; ++i) {
    const bool fills_row = i == count - 1 && i % columns == 0;
    places.push_back(
        {{corner.x + float(i % columns) * (size.x + gap), corner.y + float(i / columns) * (size.y + gap)},
         {fills_row ? room.x : size.x, size.y}});
  }
  return places;
}

}  // namespace

ShownPicture shown_by_all(const ViewsState& views) {
  return !views.exact        ? ShownPicture::as_set
         : views.error_bound ? ShownPicture::error_bound
                             : ShownPicture::exact;
}

bool views_panel(Document& document, StudioState& state, const StudioInputs& inputs, StudioRequests& requests,
                 ImVec2 room) {
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  ViewsState& views = state.views;
  std::optional<glm::vec2> cursor;
  bool changed = false;
  if (views.enlarged >= 0) {
    changed = view(document, state, inputs, requests, views.enlarged, corner, room, cursor);
  } else {
    const auto places = grid_places(views.count, corner, room);
    for (int i = 0; i < views.count; ++i) {
      const auto& [place, size] = places[std::size_t(i)];
      if (size.x < 8 || size.y < 8) continue;
      changed |= view(document, state, inputs, requests, i, place, size, cursor);
    }
  }
  views.cursor = cursor;
  for (const glm::ivec2 pixels : requests.view_pixels)
    if (pixels.x > 0) state.picture_dialog.as_shown = pixels;
  requests.shown_picture = shown_by_all(views);
  requests.contents = views.contents;
  requests.inspect = state.ray.ask;
  requests.problem = std::exchange(views.error, "");
  if (std::exchange(views.asks_for_own, false)) requests.reads_library = true;
  if (std::exchange(views.asks_for_file, false)) ask_for_file(state, document, FilePurpose::view_preset);
  if (views.comparison && views.comparison->follows)
    views.comparison->with = views.contents[std::size_t(*views.comparison->follows)];
  if (views.comparison && requests.view_pixels[std::size_t(views.comparison->view)].x > 0) {
    requests.comparison = views.comparison;
    requests.animates |= views.comparison->kind == ComparisonKind::blink;
  }
  return changed;
}

}  // namespace crest
