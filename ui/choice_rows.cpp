#include "ui/choice_rows.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "presets/names.h"
#include "ui/accuracy_shown.h"
#include "ui/style.h"

namespace crest {
namespace {

/// Of the same setting, while it is of what the document shows.
const Measurement* measured(const TriedSetting& setting, const AccuracyResults* accuracy) {
  if (!accuracy || accuracy->is_stale) return nullptr;
  const auto found = std::ranges::find_if(accuracy->measured, [&](const Measurement& m) {
    return m.method == setting.method->id && m.step == setting.step;
  });
  return found == accuracy->measured.end() ? nullptr : &*found;
}

void wrapped(ImU32 color, const std::string& text) {
  ImGui::PushStyleColor(ImGuiCol_Text, color);
  ImGui::PushTextWrapPos();
  ImGui::TextUnformatted(text.data(), text.data() + text.size());
  ImGui::PopTextWrapPos();
  ImGui::PopStyleColor();
}

}  // namespace

std::string choice_text(const ChoiceResults& choice, const AccuracyResults* accuracy) {
  if (!choice.chosen) return "";
  const TriedSetting& setting = choice.chosen->setting;
  const SampledError& error = setting.error;
  const ErrorMeasure& measure = *choice.target.measure;
  std::string text = std::string(setting.method->name);
  if (setting.method->has_step) text += " at step " + step_text(setting.step);
  text += fmt::format(": {}.\nPredicted {} {:.3g}", choice.chosen->why, measure.id, error.value);
  if (std::isfinite(error.high) && error.high > error.value)
    text += fmt::format(", at most {:.2g}", error.high);
  text += fmt::format(", and {} ms a frame.", ms_text(setting.frame_ms));
  if (const Measurement* m = measured(setting, accuracy))
    if (const ImageError* of_whole = m->error_against(chosen_answer(choice.chosen->rendering)))
      text += fmt::format("\nMeasured {} {:.3g}, and {} ms a frame of {} x {} pixels.", measure.id,
                          measure.value(*of_whole), ms_text(m->frame_ms), accuracy->size.x, accuracy->size.y);
  return text;
}

void choice_rows(const Document& document, StudioState& state, const StudioInputs& inputs,
                 StudioRequests& requests) {
  static const ChoiceResults nothing;
  const ChoiceResults& choice = inputs.choice ? *inputs.choice : nothing;
  const TargetError& target = state.accuracy.target;
  ImGui::BeginDisabled(!inputs.volume && !choice.is_running);
  const float width = ImGui::CalcTextSize("Choose for me").x + 2 * ImGui::GetStyle().FramePadding.x;
  if (ImGui::Button(choice.is_running ? "Stop##choose" : "Choose for me##choose", {width, 0})) {
    requests.stop_choosing = choice.is_running;
    if (!choice.is_running) requests.choose = target;
  }
  note_item(state.widgets, "choose");
  ImGui::EndDisabled();
  tip("Picks engine, classification, placement and step for this scene and view:\nthe fastest setting of the "
      "preset's mode that keeps the target of the Accuracy panel,\nby exact rays spread over the picture. "
      "One undo takes it back.");
  ImGui::SameLine();
  ImGui::AlignTextToFramePadding();
  ImGui::TextDisabled("%s that keeps %s",
                      choice.is_running ? "looking for the fastest setting" : "the fastest setting",
                      to_string(choice.is_running ? choice.target : target).c_str());
  if (!choice.error.empty()) {
    wrapped(palette().error, "Nothing was chosen: " + choice.error);
    note_item(state.widgets, "choice error");
  }
  // Once the person has set something else, it tells of what is not there
  if (!choice.chosen || choice.chosen->rendering != document.preset.rendering) return;
  wrapped(choice.chosen->meets_target ? palette().good : palette().warning,
          choice_text(choice, inputs.accuracy));
  note_item(state.widgets, choice.chosen->meets_target ? "chosen" : "chosen, target missed");
  if (state.views.exact) ImGui::TextDisabled("The views show the exact picture; X shows this one.");
}

}  // namespace crest
