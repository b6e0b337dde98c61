#include "ui/views_panel.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "presets/choices.h"
#include "presets/names.h"
#include "render/scene/camera.h"
#include "render/scene/error_colors.h"
#include "render/scene/exact.h"
#include "ui/camera_control.h"
#include "ui/mode_text.h"
#include "ui/style.h"
#include "ui/view_overlay.h"
#include "ui/warning_sign.h"

namespace crest {
namespace {

constexpr double turn_per_pixel = 0.008;  // radians
constexpr double dolly_per_notch = 0.88;
constexpr float least_view = 24;  // pixels

std::string cost_text(const ViewPicture& view) {
  if (view.frame_ms <= 0) return "";
  std::string text =
      view.frame_ms < 100 ? fmt::format("{:.1f} ms", view.frame_ms) : fmt::format("{:.0f} ms", view.frame_ms);
  if (view.is_exact && view.samples_per_ray > 0)
    text += fmt::format("   {:.1f} cells/ray", view.samples_per_ray);
  else if (view.samples_per_ray > 0)
    text += fmt::format("   {:.1f} samples/ray, {:.1f} DVR", view.samples_per_ray, view.dvr_samples_per_ray);
  return text;
}

Rendering with_mode(Rendering rendering, Mode mode) {
  rendering.mode = mode;
  return rendering;
}

void right_aligned(const char* text, float right) {
  const float width = ImGui::CalcTextSize(text).x;
  ImGui::SameLine(std::max(0.0F, right - width));
  ImGui::TextDisabled("%s", text);
}

/// Of an exact picture: how sure that is, and what it is of.
std::string exact_text(const ViewPicture& view, Mode mode, bool is_lit) {
  std::string sure;
  if (view.progress < 1)
    sure = "becoming exact";
  else if (!view.share_within)
    sure = "exact";
  else
    sure = fmt::format("exact, {:.4g} % surely within 1/255{}", std::floor(1e4 * *view.share_within) / 100,
                       is_lit ? " but for light" : "");
  return fmt::format("{}: {}", sure, exact_explanation_of(mode));
}

/// What the view shows, in one line, and more of it under the mouse.
void explanation(const Rendering& rendering, const ViewsState& views, const ViewPicture& view, Mode mode) {
  const bool is_lit = takes_gradient(rendering.shading);
  const std::string text = view.is_exact ? exact_text(view, mode, is_lit) : explanation_of(mode);
  ImGui::PushStyleColor(ImGuiCol_Text, palette::dim);
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopStyleColor();
  std::string more = text;
  if (view.is_exact)
    more +=
        "\nBy bounds on all errors along a ray, of a 64th of the pixels; light is not in them."
        "\nX shows the picture as the settings have it, B how far each pixel may be off.";
  else if (const std::string why_not = why_not_exact(with_mode(rendering, mode)); !why_not.empty())
    more += "\nNot exact: " + why_not;
  else if (!views.exact)
    more += "\nAs the settings have it; X shows the exact picture.";
  tip(more.c_str());
}

/// The name, whether it may be off, what it costs, and what it shows.
void caption(int index, StudioState& state, const ViewPicture& view, const Rendering& rendering) {
  const Engine engine = rendering.engine;
  const Mode mode = view_modes[std::size_t(index)];
  std::string name(name_of(mode));
  if (engine == Engine::vdls && mode == Mode::dvr_only && !view.is_exact) name += ": vdls";
  const float width = ImGui::GetContentRegionAvail().x, start = ImGui::GetCursorPosX();
  const bool enlarged = state.views.enlarged == index;
  ImGui::TextUnformatted(name.c_str());
  float named = ImGui::CalcTextSize(name.c_str()).x;
  if (!view.warnings.empty()) {
    ImGui::SameLine(0, scaled(8));
    warning_sign(state.widgets, fmt::format("warning{}", index), view.warnings);
    named += scaled(8) + ImGui::GetItemRectSize().x;
  }
  const char* action = enlarged ? "restore" : "enlarge";
  const float button = ImGui::CalcTextSize(action).x + 2 * ImGui::GetStyle().FramePadding.x;
  const std::string cost = cost_text(view);
  const float cost_room = width - button - scaled(8) - named - scaled(12);
  if (!cost.empty() && ImGui::CalcTextSize(cost.c_str()).x < cost_room)
    right_aligned(cost.c_str(), start + width - button - scaled(8));
  ImGui::SameLine(start + width - button);
  if (ImGui::SmallButton(action)) state.views.enlarged = enlarged ? -1 : index;
  note_item(state.widgets, fmt::format("enlarge{}", index));
  explanation(rendering, state.views, view, mode);
}

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
  list.AddText({at.x + scaled(6), at.y + (height - ImGui::GetFontSize()) / 2}, palette::dim, text.c_str());
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

void picture(const StudioState& state, const StudioInputs& inputs, const ViewPicture& view,
             const Camera& camera, ImVec2 low, ImVec2 size) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 high{low.x + size.x, low.y + size.y};
  if (view.texture != 0)
    list.AddImage(reinterpret_cast<ImTextureID>(view.texture), low, high);
  else
    list.AddRectFilled(low, high, palette::plot);
  list.PushClipRect(low, high, true);
  if (inputs.volume && state.views.outline) draw_outline(list, camera, inputs.volume->grid, low, size);
  if (!inputs.volume) {
    const char* hint =
        inputs.loading.empty() ? "Volume > Open, or drop a file here" : "Reading the volume ...";
    const ImVec2 text = ImGui::CalcTextSize(hint);
    list.AddText({low.x + (size.x - text.x) / 2, low.y + (size.y - text.y) / 2}, palette::faint, hint);
  }
  if (view.texture != 0 && (view.coarseness > 1 || view.progress < 1)) {
    const std::string hint = view.coarseness > 1 ? fmt::format("coarse 1:{}", view.coarseness)
                             : view.is_exact     ? fmt::format("exact: {:.0f} %", 100 * view.progress)
                                                 : "refining";
    list.AddText({low.x + scaled(8), high.y - ImGui::GetFontSize() - scaled(8)}, palette::dim, hint.c_str());
    const float done = size.x * float(std::clamp(view.progress, 0.0, 1.0));
    list.AddRectFilled({low.x, high.y - scaled(2)}, {low.x + done, high.y}, palette::accent);
  }
  if (state.views.error_bound && view.is_exact) error_legend(list, {low.x + scaled(8), low.y + scaled(8)});
  list.PopClipRect();
}

bool view(Document& document, StudioState& state, const StudioInputs& inputs, StudioRequests& requests,
          int index, ImVec2 corner, ImVec2 size) {
  const std::size_t i = std::size_t(index);
  ImGui::PushID(index);
  ImGui::SetCursorScreenPos(corner);
  ImGui::BeginChild("view", size, false, ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
  caption(index, state, inputs.views[i], document.preset.rendering);
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
    Camera camera;
    if (inputs.volume) camera = camera_of(document.preset, inputs.volume->grid, double(image.x / image.y));
    if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left))
      state.views.enlarged = state.views.enlarged == index ? -1 : index;
    else if (inputs.volume)
      changed = move_camera(document, state, inputs.volume->grid, camera, image.y);
    picture(state, inputs, inputs.views[i], document.preset.camera.value_or(camera), low, image);
  }
  ImGui::EndChild();
  ImGui::PopID();
  return changed;
}

}  // namespace

bool views_panel(Document& document, StudioState& state, const StudioInputs& inputs,
                 StudioRequests& requests) {
  const ImVec2 corner = ImGui::GetCursorScreenPos(), room = ImGui::GetContentRegionAvail();
  requests.shown_picture = !state.views.exact        ? ShownPicture::as_set
                           : state.views.error_bound ? ShownPicture::error_bound
                                                     : ShownPicture::exact;
  const int enlarged = state.views.enlarged;
  if (enlarged >= 0) return view(document, state, inputs, requests, enlarged, corner, room);
  const float gap = scaled(8);
  const ImVec2 size{std::floor((room.x - gap) / 2), std::floor((room.y - gap) / 2)};
  if (size.x < 8 || size.y < 8) return false;
  bool changed = false;
  for (int i = 0; i < view_count; ++i)
    changed |=
        view(document, state, inputs, requests, i,
             {corner.x + float(i % 2) * (size.x + gap), corner.y + float(i / 2) * (size.y + gap)}, size);
  return changed;
}

}  // namespace crest
