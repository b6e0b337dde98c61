#include "ui/card.h"

#include <algorithm>
#include <cmath>

#include "ui/navigation.h"
#include "ui/style.h"

namespace crest {
namespace {

constexpr float width = 208, picture_height = 156, pad = 6, gap = 12;

}  // namespace

ImVec2 card_size() {
  return {scaled(width), scaled(picture_height + 3 * pad) + 3 * ImGui::GetTextLineHeightWithSpacing()};
}

bool card(WidgetState& state, const Card& what) {
  const ImVec2 low = ImGui::GetCursorScreenPos(), size = card_size();
  const bool pressed = ImGui::InvisibleButton(what.name.c_str(), size);
  note_item(state, what.name);
  const ImGuiID id = ImGui::GetID(what.name.c_str());
  const bool is_hovered = ImGui::IsItemHovered();
  if (is_hovered && !what.tooltip.empty()) {
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(scaled(420));
    ImGui::TextUnformatted(what.tooltip.c_str());
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
  }

  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 high{low.x + size.x, low.y + size.y};
  const ImVec2 picture_high{high.x, low.y + scaled(picture_height)};
  list.AddRectFilled(low, high, is_hovered ? palette().raised : palette().card, scaled(4));
  list.AddRectFilled(low, picture_high, palette().plot, scaled(4), ImDrawFlags_RoundCornersTop);
  if (what.picture != 0)
    list.AddImageRounded(reinterpret_cast<ImTextureID>(what.picture), low, picture_high, {0, 0}, {1, 1},
                         IM_COL32_WHITE, scaled(4), ImDrawFlags_RoundCornersTop);
  if (is_hovered) list.AddRect(low, high, palette().accent, scaled(4));

  show_focus(id, low, high);

  const float room = size.x - scaled(2 * pad), line = ImGui::GetTextLineHeightWithSpacing();
  const ImVec2 at{low.x + scaled(pad), picture_high.y + scaled(pad)};
  list.AddText(at, palette().text, shortened(what.title, room).c_str());
  list.PushClipRect(low, high, true);
  list.AddText(ImGui::GetFont(), ImGui::GetFontSize(), {at.x, at.y + line}, palette().secondary,
               what.text.c_str(), nullptr, room);
  list.PopClipRect();
  return pressed;
}

int column_count() {
  const float room = ImGui::GetContentRegionAvail().x + scaled(gap);
  return std::max(1, int(std::floor(room / (card_size().x + scaled(gap)))));
}

void place_card(int index, int columns) {
  if (index % columns != 0)
    ImGui::SameLine(0, scaled(gap));
  else if (index > 0)
    ImGui::Dummy({0, scaled(gap) - ImGui::GetStyle().ItemSpacing.y});
}

}  // namespace crest
