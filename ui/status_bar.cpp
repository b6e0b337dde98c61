#include "ui/status_bar.h"

#include <fmt/core.h>

#include <cmath>

#include "ui/style.h"

namespace crest {
namespace {

std::string volume_text(const Volume* volume) {
  if (!volume) return "no volume";
  const glm::ivec3 dims = volume->grid.dims;
  const ValueRange range = volume->statistics.range;
  std::string text = fmt::format("{}   {} x {} x {}", volume->name, dims.x, dims.y, dims.z);
  if (volume->part) text += fmt::format(", {}", short_part_text(*volume->part));
  text += fmt::format("   {}   {:.6g} .. {:.6g}", name_of(volume->file_type), range.min, range.max);
  const auto add = [&](std::size_t count, const char* what) {
    if (count > 0) text += fmt::format("   {} {}", count, what);
  };
  add(volume->statistics.nan_count, "NaN");
  add(volume->statistics.inf_count, "Inf");
  if (!volume->note.empty()) text += "   " + volume->note;
  return text;
}

/// A bar, filled by how much is read, or moving to and fro while nobody knows; what is read, and a button
/// that stops it. Returns their width.
float loading_sign(StudioState& state, const StudioInputs& inputs, StudioRequests& requests) {
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const float height = ImGui::GetFontSize(), width = scaled(80), moving = scaled(24), gap = scaled(8);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(corner, {corner.x + width, corner.y + height}, palette().frame);
  const float swing = 0.5F - 0.5F * float(std::cos(2 * ImGui::GetTime()));
  const float left = inputs.loading_share ? 0 : (width - moving) * swing,
              right = inputs.loading_share ? width * float(*inputs.loading_share) : left + moving;
  const ImVec2 from{corner.x + left, corner.y}, to{corner.x + right, corner.y + height};
  list.AddRectFilled(from, to, palette().accent);
  std::string text = fmt::format("Reading {} ...", inputs.loading);
  if (inputs.loading_share) {
    state.widgets.items["loaded share"] = {from, to};
    text += fmt::format(" {:.0f} %", 100 * *inputs.loading_share);
  }
  const float text_width = ImGui::CalcTextSize(text.c_str()).x;
  list.AddText({corner.x + width + gap, corner.y}, palette().text, text.c_str());
  ImGui::SetCursorScreenPos({corner.x + width + gap + text_width + gap, corner.y});
  requests.cancel_loading = ImGui::SmallButton("cancel");
  note_item(state.widgets, "cancel loading");
  return ImGui::GetItemRectMax().x - corner.x;
}

}  // namespace

void status_bar(StudioState& state, const StudioInputs& inputs, StudioRequests& requests) {
  const auto width_of = [](const std::string& text) { return ImGui::CalcTextSize(text.c_str()).x; };
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 corner = ImGui::GetCursorScreenPos(), room = ImGui::GetContentRegionAvail();
  const float gap = scaled(24);
  float left = corner.x, right = corner.x + room.x;
  if (!inputs.loading.empty()) left += loading_sign(state, inputs, requests) + gap;
  const auto write_left = [&](const std::string& text, ImU32 color) {
    if (text.empty() || left >= right) return;
    list.PushClipRect({left, corner.y}, {right, corner.y + room.y + scaled(4)}, true);
    list.AddText({left, corner.y}, color, shortened(text, right - left).c_str());
    list.PopClipRect();
    left += width_of(text) + gap;
  };
  const auto write_right = [&](const std::string& text, ImU32 color) {
    const float width = width_of(text);
    if (text.empty() || right - width < left) return;
    list.AddText({right - width, corner.y}, color, text.c_str());
    right -= width + gap;
  };
  write_right(inputs.performance, palette().secondary);
  write_right(inputs.saving, palette().accent);
  write_left(volume_text(inputs.volume), palette().secondary);
  if (!inputs.message_is_error) write_left(inputs.message, palette().text);
}

}  // namespace crest
