#include "ui/error_banner.h"

#include <algorithm>

#include "ui/keys.h"
#include "ui/style.h"
#include "ui/warning_sign.h"

namespace crest {
namespace {

constexpr ImGuiWindowFlags over_all = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                      ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing |
                                      ImGuiWindowFlags_AlwaysAutoResize;

}  // namespace

bool has_error(const StudioInputs& inputs) { return inputs.message_is_error && !inputs.message.empty(); }

void error_banner(StudioState& state, const StudioInputs& inputs, StudioRequests& requests, ImVec2 corner,
                  float width) {
  if (!has_error(inputs)) return;
  const float margin = scaled(8), inside = std::max(width - 2 * margin, scaled(160));
  ImGui::SetNextWindowPos({corner.x + margin, corner.y + margin});
  ImGui::SetNextWindowSizeConstraints({inside, 0}, {inside, 1e4F});
  ImGui::PushStyleColor(ImGuiCol_WindowBg, palette().alarm);
  ImGui::PushStyleColor(ImGuiCol_Border, palette().error);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1);
  ImGui::Begin("error banner", nullptr, over_all);
  const ImVec2 padding = ImGui::GetStyle().WindowPadding;
  const float start = ImGui::GetCursorPosX(), button = ImGui::GetFrameHeight();
  const float text = start + ImGui::GetFontSize() + scaled(10), right = inside - padding.x - button;
  ImGui::AlignTextToFramePadding();
  draw_warning_sign(
      *ImGui::GetWindowDrawList(),
      {ImGui::GetCursorScreenPos().x, ImGui::GetCursorScreenPos().y + ImGui::GetStyle().FramePadding.y},
      ImGui::GetFontSize(), palette().error, palette().alarm);
  ImGui::SetCursorPosX(text);
  const float top = ImGui::GetCursorPosY();
  ImGui::PushTextWrapPos(right - scaled(10));
  ImGui::TextUnformatted(inputs.message.c_str());
  ImGui::PopTextWrapPos();
  ImGui::SetCursorPos({right, top});
  if (ImGui::Button("x##close error", {button, button})) requests.close_message = true;
  note_item(state.widgets, "close error");
  tip("Close (Esc)");
  state.widgets.items["error banner"] = {ImGui::GetWindowPos(),
                                         {ImGui::GetWindowPos().x + ImGui::GetWindowSize().x,
                                          ImGui::GetWindowPos().y + ImGui::GetWindowSize().y}};
  ImGui::End();
  ImGui::PopStyleVar();
  ImGui::PopStyleColor(2);
}

void close_error_by_key(StudioState& state, const StudioInputs& inputs, StudioRequests& requests) {
  if (!has_error(inputs) || ImGui::IsAnyItemActive()) return;
  // Esc closed one before the frame began
  if (ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup) || state.navigation.popups > 0) return;
  if (!key_pressed(key::escape)) return;
  requests.close_message = true;
  state.widgets.escape_taken = true;
}

}  // namespace crest
