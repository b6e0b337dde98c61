#include "ui/accuracy_answers.h"

#include <fmt/core.h>

#include <algorithm>

#include "presets/names.h"
#include "render/measure/model_difference.h"
#include "ui/mode_text.h"
#include "ui/style.h"
#include "ui/widgets.h"

namespace crest {
namespace {

/// The four of the field that was measured, then those of other filters.
std::vector<ExactAnswer> offered_answers(const ShownAccuracy& shown) {
  std::vector<ExactAnswer> answers;
  for (const Answer answer :
       {Answer::integral, Answer::crossings, Answer::integral_and_crossings, Answer::base_and_crossings})
    answers.emplace_back(answer, filters_of(answer, shown.results.rendering));
  const auto add = [&](const ExactAnswer& answer) {
    if (std::ranges::find(answers, answer) == answers.end()) answers.push_back(answer);
  };
  for (const Measurement& m : shown.results.measured)
    for (const AnswerError& error : m.errors) add(error.answer);
  add(shown.answer);
  return answers;
}

const char* explanation_of(Answer answer) {
  switch (answer) {
    case Answer::integral:
      return "The volume rendering integral of the transfer function";
    case Answer::crossings:
      return "The peaks' surfaces where rays cross them, nothing else";
    case Answer::integral_and_crossings:
      return "The integral of the whole transfer function, and the peaks' surfaces";
    case Answer::base_and_crossings:
      break;
  }
  return "The integral without the spikes, and the peaks' surfaces";
}

/// "Surfaces + volume", and the filters where they are not those that were measured with.
std::string answer_title(const ExactAnswer& answer) {
  const std::string name = name_of(answer);
  const std::size_t filters = std::min(name.find(" ("), name.size());
  return title_of(mode_of(answer.answer)) + name.substr(filters);
}

/// Which views show the mode: the grid, with their places filled, at the left of the last button.
void draw_view_mark(const ViewsState& views, Mode mode, ImU32 color) {
  const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
  const float side = std::floor(ImGui::GetFontSize() * 0.38F), gap = scaled(1);
  const ImVec2 corner{low.x + ImGui::GetStyle().FramePadding.x,
                      std::floor((low.y + high.y) / 2 - side - gap / 2)};
  ImDrawList& list = *ImGui::GetWindowDrawList();
  for (int i = 0; i < view_count; ++i) {
    const ImVec2 at{corner.x + float(i % 2) * (side + gap), corner.y + float(i / 2) * (side + gap)};
    const ImVec2 end{at.x + side, at.y + side};
    if (views.contents[std::size_t(i)].mode == mode)
      list.AddRectFilled(at, end, color);
    else
      list.AddRect(at, end, palette().secondary);
  }
}

}  // namespace

Mode mode_of(Answer answer) {
  switch (answer) {
    case Answer::integral:
      return Mode::dvr_only;
    case Answer::crossings:
      return Mode::peak_only;
    case Answer::integral_and_crossings:
      return Mode::both;
    case Answer::base_and_crossings:
      break;
  }
  return Mode::peak_xor_dvr;
}

std::string model_text(const ShownAccuracy& shown) {
  const std::string whose = fmt::format("The exact answer of \"{}\"", title_of(mode_of(shown.answer.answer)));
  if (shown.answer == own_integral(shown.results.rendering))
    return whose + ": the integral, from which the others are told apart";
  const auto& known = shown.results.model_differences;
  const auto found = std::ranges::find(known, shown.answer, &AnswerError::answer);
  if (found == known.end() || found->error.compared.pixels == 0) return whose;
  const double percent = 100 * found->error.compared.share;
  const bool own_field = shown.answer.filters == filters_of(shown.answer.answer, shown.results.rendering);
  const char* cause = !own_field                                ? "the mode and the filter"
                      : shown.answer.answer == Answer::integral ? "the filter"
                                                                : "the mode";
  return fmt::format("{} differs from the integral in {:.2g} % of the pixels: that is {}, not an error",
                     whose, percent, cause);
}

void answer_rows(StudioState& state, const ShownAccuracy& shown) {
  field_label("Against");
  const float begin = ImGui::GetCursorPosX(), right = begin + ImGui::GetContentRegionAvail().x;
  for (const ExactAnswer& answer : offered_answers(shown)) {
    const std::string name = name_of(answer);
    const bool is_there = std::ranges::any_of(
        shown.results.measured, [&](const Measurement& m) { return m.error_against(answer) != nullptr; });
    const bool is_shown = answer == shown.answer;
    const float mark = ImGui::GetFontSize() + scaled(4);
    const std::string text = answer_title(answer);
    const float width = ImGui::CalcTextSize(text.c_str()).x + mark + 2 * ImGui::GetStyle().FramePadding.x;
    if (ImGui::GetCursorPosX() > begin && ImGui::GetCursorPosX() + width > right) {
      ImGui::NewLine();
      ImGui::SetCursorPosX(begin);
    }
    ImGui::PushStyleColor(ImGuiCol_Button,
                          ImGui::GetStyleColorVec4(is_shown ? ImGuiCol_HeaderActive : ImGuiCol_FrameBg));
    ImGui::PushStyleColor(ImGuiCol_Text, is_there || is_shown ? palette().text : palette().secondary);
    ImGui::PushStyleVar(ImGuiStyleVar_ButtonTextAlign, {1, 0.5F});
    if (ImGui::Button(fmt::format("{}##{}", text, name).c_str(), {width, 0})) state.accuracy.answer = answer;
    ImGui::PopStyleVar();
    ImGui::PopStyleColor(2);
    draw_view_mark(state.views, mode_of(answer.answer),
                   is_there || is_shown ? palette().text : palette().secondary);
    note_item(state.widgets, "answer/" + name);
    tip(fmt::format("{}:\nwhat the view \"{}\" is measured against; {} in reports",
                    explanation_of(answer.answer), title_of(mode_of(answer.answer)), name)
            .c_str());
    ImGui::SameLine(0, scaled(3));
  }
  ImGui::NewLine();
  ImGui::PushTextWrapPos();
  ImGui::TextDisabled("%s", model_text(shown).c_str());
  ImGui::PopTextWrapPos();
  note_item(state.widgets, "model: " + model_text(shown));
}

}  // namespace crest
