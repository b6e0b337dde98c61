#include "ui/help_window.h"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

#include "ui/actions.h"
#include "ui/navigation.h"
#include "ui/questions.h"
#include "ui/style.h"

namespace crest {
namespace {

struct Gesture {
  const char* gesture;  ///< empty: the rest is a heading
  const char* meaning;
};

/// What is no action of the table: the mouse, and keys that mean more the longer they are held.
constexpr Gesture gestures[] = {
    {"", "Mouse over the transfer function"},
    {"double-click", "add a point; on a point: its colour; on the axis: show all values"},
    {"drag",
     "move the selected points; Shift keeps the axis, Alt does not snap;\non empty ground: select a box"},
    {"bar over the plot", "drag: shift the selected points, or all; its ends stretch them"},
    {"Ctrl+click", "add to the selection"},
    {"right-click", "menu: add a peak, step or other shape; surface auto, on or off"},
    {"wheel", "zoom about the mouse; Ctrl: faster; Shift: pan"},
    {"middle drag", "pan; also: drag the axis"},
    {"blue triangle", "a value where the volume is steep: click to add a spike there"},
    {"", "Points"},
    {"arrows", "nudge by a pixel; Shift: by 10, Alt: by a tenth"},
    {"Ctrl+Right, Ctrl+Left", "select the next point, the one before"},
    {"", "Mouse over the views"},
    {"left drag", "turn"},
    {"middle or right drag", "move; also: Shift+left drag"},
    {"wheel", "nearer, further; in parallel projection: magnify"},
    {"double-click", "enlarge a view, and back"},
    {"click", "inspect the pixel's ray"},
    {"right-click", "select the peak that shows there, or make one"},
    {"", "Keys in a view that has the focus"},
    {"arrows", "turn; Shift: move"},
    {"Page up, Page down", "as the wheel"},
    {"", "Slices"},
    {"left drag, wheel", "move the cursor; the next slice"},
};

void title(const char* text) {
  ImGui::Spacing();
  heading(text);
}

void line(const std::string& keys, const char* meaning, float indent) {
  ImGui::TextUnformatted(keys.c_str());
  ImGui::SameLine(indent);
  ImGui::TextDisabled("%s", meaning);
}

void keys_of(WidgetState& widgets, Section section) {
  bool any = false;
  for (const Action& action : actions()) {
    if (action.section != section || action.key.key == 0) continue;
    if (!std::exchange(any, true)) title(std::string(title_of(section)).c_str());
    const std::string other = text_of(action.other_key);
    line(fmt::format("{}{}{}", key_text_of(action), other.empty() ? "" : ", ", other), action.name.c_str(),
         scaled(160));
    if (ImGui::IsItemVisible()) note_item(widgets, "key/" + action.name);
  }
}

void mouse_list() {
  for (const Gesture& gesture : gestures)
    if (*gesture.gesture == '\0')
      title(gesture.meaning);
    else
      line(gesture.gesture, gesture.meaning, scaled(160));
}

}  // namespace

void help_window(StudioState& state) {
  constexpr const char* name = "Keys and mouse";
  if (state.show_help) ImGui::OpenPopup(name);
  state.show_help = false;
  center_next_window();
  const ImVec2 display = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowSize(
      {std::min(scaled(960), display.x * 0.95F), std::min(scaled(940), display.y * 0.95F)});
  bool open = true;
  if (!ImGui::BeginPopupModal(name, &open, ImGuiWindowFlags_NoResize)) return;
  const float height = ImGui::GetContentRegionAvail().y - ImGui::GetFrameHeightWithSpacing() - scaled(4);
  ImGui::BeginChild("keys", {scaled(360), height}, false, ImGuiWindowFlags_NavFlattened);
  for (int i = 0; i < menu_count; ++i) keys_of(state.widgets, Section(i));
  ImGui::EndChild();
  ImGui::SameLine();
  ImGui::BeginChild("mouse", {0, height}, false, ImGuiWindowFlags_NavFlattened);
  for (int i = menu_count; i < section_count; ++i) keys_of(state.widgets, Section(i));
  mouse_list();
  ImGui::EndChild();
  if (default_button("Close", {scaled(104), 0}) || escape_pressed(state.widgets)) ImGui::CloseCurrentPopup();
  note_item(state.widgets, "close help");
  ImGui::EndPopup();
}

void about_window(StudioState& state, const std::string& version) {
  constexpr const char* name = "About Crest";
  if (std::exchange(state.show_about, false)) ImGui::OpenPopup(name);
  center_next_window();
  bool open = true;
  if (!ImGui::BeginPopupModal(name, &open, ImGuiWindowFlags_AlwaysAutoResize)) return;
  ImGui::TextUnformatted(fmt::format("Crest {}", version).c_str());
  ImGui::TextDisabled("Transfer functions for volume rendering, whose peaks are not lost.");
  ImGui::Spacing();
  if (default_button("Close", {scaled(104), 0}) || escape_pressed(state.widgets)) ImGui::CloseCurrentPopup();
  note_item(state.widgets, "close about");
  ImGui::EndPopup();
}

}  // namespace crest
