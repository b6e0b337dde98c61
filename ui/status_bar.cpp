#include "ui/status_bar.h"

#include <fmt/core.h>

#include "ui/style.h"

namespace crest {
namespace {

std::string volume_text(const Volume* volume) {
  if (!volume) return "no volume";
  const glm::ivec3 dims = volume->grid.dims;
  const ValueRange range = volume->statistics.range;
  std::string text = fmt::format("{}   {} x {} x {}   {}   {:.6g} .. {:.6g}", volume->name, dims.x, dims.y,
                                 dims.z, name_of(volume->file_type), range.min, range.max);
  const auto add = [&](std::size_t count, const char* what) {
    if (count > 0) text += fmt::format("   {} {}", count, what);
  };
  add(volume->statistics.nan_count, "NaN");
  add(volume->statistics.inf_count, "Inf");
  if (!volume->note.empty()) text += "   " + volume->note;
  return text;
}

}  // namespace

void status_bar(const StudioState& state, const StudioInputs& inputs) {
  const auto width_of = [](const std::string& text) { return ImGui::CalcTextSize(text.c_str()).x; };
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 corner = ImGui::GetCursorScreenPos(), room = ImGui::GetContentRegionAvail();
  const float gap = scaled(24);
  float left = corner.x, right = corner.x + room.x;
  const auto write_left = [&](const std::string& text, ImU32 color) {
    if (text.empty() || left >= right) return;
    list.PushClipRect({left, corner.y}, {right, corner.y + room.y + scaled(4)}, true);
    list.AddText({left, corner.y}, color, text.c_str());
    list.PopClipRect();
    left += width_of(text) + gap;
  };
  const auto write_right = [&](const std::string& text, ImU32 color) {
    const float width = width_of(text);
    if (text.empty() || right - width < left) return;
    list.AddText({right - width, corner.y}, color, text.c_str());
    right -= width + gap;
  };
  // An error is told first, and whole.
  if (inputs.message_is_error) write_left(inputs.message, palette::error);
  write_right(inputs.performance, palette::faint);
  write_left(volume_text(inputs.volume), palette::dim);
  write_right(state.under_cursor, palette::text);
  if (!inputs.message_is_error) write_left(inputs.message, palette::text);
}

}  // namespace crest
