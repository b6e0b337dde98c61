#include "ui/recovery_banner.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "ui/style.h"

namespace crest {

std::string age_text(double seconds) {
  constexpr std::pair<double, const char*> units[] = {
      {7 * 86400, "week"}, {86400, "day"}, {3600, "hour"}, {60, "minute"}};
  for (const auto& [length, name] : units)
    if (seconds >= length) {
      const double count = std::floor(seconds / length);
      return fmt::format("{:.0f} {}{} ago", count, name, count == 1 ? "" : "s");
    }
  return "just now";
}

void recovery_banner(StudioState& state, const StudioInputs& inputs, StudioRequests& requests) {
  if (!inputs.recovery) return;
  const RecoveryOffer& offer = *inputs.recovery;
  const ImVec2 low = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x, pad = scaled(6);
  const float height = ImGui::GetFrameHeight() + 2 * pad;
  ImGui::GetWindowDrawList()->AddRectFilled(low, {low.x + width, low.y + height}, palette().caution,
                                            scaled(4));
  ImGui::SetCursorScreenPos({low.x + scaled(10), low.y + pad});
  ImGui::BeginGroup();
  ImGui::AlignTextToFramePadding();
  std::string text =
      fmt::format("Crest ended with unsaved changes to {}, {}.", offer.name, age_text(offer.age));
  if (offer.more > 0) text += fmt::format(" {} more after this.", offer.more);
  ImGui::PushStyleColor(ImGuiCol_Text, palette().warning);
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopStyleColor();
  if (!offer.volume.empty()) tip(("With " + offer.volume).c_str());
  const auto button = [&](const char* name, RecoveryAnswer answer, const char* meaning) {
    ImGui::SameLine(0, scaled(10));
    if (ImGui::Button(name)) requests.recovery = answer;
    note_item(state.widgets, fmt::format("recovery/{}", name));
    tip(meaning);
  };
  button("Restore", RecoveryAnswer::restore,
         "Open them, unsaved as they were. What is open now comes back with Undo.");
  button("Discard", RecoveryAnswer::discard, "Remove them for good");
  button("Later", RecoveryAnswer::later, "Ask again at the next start");
  ImGui::EndGroup();
  ImGui::SetCursorScreenPos({low.x, low.y + height + ImGui::GetStyle().ItemSpacing.y});
}

}  // namespace crest
