#include "ui/time_step_row.h"

#include <fmt/core.h>

#include <algorithm>

#include "ui/actions.h"
#include "ui/number_field.h"
#include "ui/style.h"

namespace crest {
namespace {

/// What is behind the slider: where the eye finds it only when it has something to say.
std::string text_of(const ShownSteps& steps) {
  std::string text = fmt::format("0 to {}", steps.count - 1);
  if (steps.wanted != steps.shown) text += fmt::format("   step {} is shown", steps.shown);
  if (steps.known_ranges < steps.count)
    text += fmt::format("   range of {} of {} steps", steps.known_ranges, steps.count);
  return text;
}

bool button(StudioState& state, const char* text, const char* name, const std::string& meaning) {
  const bool pressed = ImGui::Button(fmt::format("{}##{}", text, name).c_str(), {scaled(56), 0});
  note_item(state.widgets, name);
  tip(meaning.c_str());
  return pressed;
}

std::string tip_of(const char* action) {
  return fmt::format("{} ({})", action_named(action).name, key_text_of(action));
}

}  // namespace

float time_step_row_height() { return ImGui::GetFrameHeight() + scaled(8); }

void time_step_row(StudioState& state, const StudioInputs& inputs, StudioRequests& requests) {
  if (!inputs.steps) return;
  const ShownSteps& steps = *inputs.steps;
  const int last = steps.count - 1;
  const float gap = scaled(6);
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted("Time step");
  ImGui::SameLine(0, gap);
  if (button(state, "<", "previous step", tip_of("Previous time step")))
    requests.go_to_step = std::max(steps.wanted - 1, 0);
  ImGui::SameLine(0, gap);
  if (button(state, steps.is_playing ? "Stop" : "Play", "play steps", tip_of("Play time steps")))
    requests.play_steps = !steps.is_playing;
  ImGui::SameLine(0, gap);
  if (button(state, ">", "next step", tip_of("Next time step")))
    requests.go_to_step = std::min(steps.wanted + 1, last);
  ImGui::SameLine(0, gap);

  const std::string text = text_of(steps);
  const float field = scaled(72);
  const float room = ImGui::GetContentRegionAvail().x - field - ImGui::CalcTextSize(text.c_str()).x - 3 * gap;
  int step = steps.wanted;
  ImGui::SetNextItemWidth(std::max(room, scaled(80)));
  if (ImGui::SliderInt("##step slider", &step, 0, last, "", ImGuiSliderFlags_AlwaysClamp))
    requests.go_to_step = step;
  note_item(state.widgets, "step slider");
  ImGui::SameLine(0, gap);
  if (integer_field(state.widgets, "##time step", step, 0, last, field)) requests.go_to_step = step;
  ImGui::SameLine(0, gap);
  ImGui::TextDisabled("%s", text.c_str());
}

}  // namespace crest
