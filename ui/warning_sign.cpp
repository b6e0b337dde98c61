#include "ui/warning_sign.h"

#include "ui/style.h"

namespace crest {

void draw_warning_sign(ImDrawList& list, ImVec2 low, float size, ImU32 color, ImU32 ground) {
  const float middle = low.x + size / 2, top = low.y + size * 0.1F, bottom = low.y + size * 0.92F;
  list.AddTriangleFilled({middle, top}, {low.x + size, bottom}, {low.x, bottom}, color);
  const float width = size / 10;
  list.AddRectFilled({middle - width / 2, low.y + size * 0.38F}, {middle + width / 2, low.y + size * 0.66F},
                     ground);
  list.AddRectFilled({middle - width / 2, low.y + size * 0.73F}, {middle + width / 2, low.y + size * 0.83F},
                     ground);
}

void warning_sign(WidgetState& state, std::string name, std::span<const std::string> warnings) {
  const float size = ImGui::GetFontSize();
  draw_warning_sign(*ImGui::GetWindowDrawList(), ImGui::GetCursorScreenPos(), size, palette().warning,
                    palette().window);
  ImGui::Dummy({size, size});
  note_item(state, std::move(name));
  if (!ImGui::IsItemHovered()) return;
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(scaled(400));
  for (const std::string& warning : warnings) {
    if (&warning != &warnings.front()) ImGui::Spacing();
    ImGui::TextUnformatted(warning.c_str());
  }
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
}

}  // namespace crest
