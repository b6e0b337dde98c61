#include "render/reference/answer.h"

namespace crest {

std::string_view name_of(Answer answer) {
  switch (answer) {
    case Answer::integral:
      return "integral";
    case Answer::crossings:
      return "crossings";
    case Answer::integral_and_crossings:
      return "integral+crossings";
    case Answer::base_and_crossings:
      return "base+crossings";
  }
  return "";
}

AnswerFilters filters_of(Answer answer, const Rendering& rendering) {
  AnswerFilters filters{dvr_filter(rendering), root_filter(rendering)};
  if (answer == Answer::integral) filters.root = filters.dvr;
  if (answer == Answer::crossings) filters.dvr = filters.root;
  for (FieldFilter* filter : {&filters.dvr, &filters.root})
    if (filter->kind == Filter::linear_exact) filter->kind = Filter::linear;
  return filters;
}

std::vector<Answer> answers_of(const Rendering& rendering) {
  switch (rendering.mode) {
    case Mode::dvr_only:
      return {Answer::integral};
    case Mode::peak_only:
      return {Answer::crossings};
    case Mode::both:
      return {Answer::integral_and_crossings};
    case Mode::peak_xor_dvr:
      break;
  }
  if (rendering.peak_form == PeakForm::split) return {Answer::base_and_crossings};
  return {Answer::integral_and_crossings, Answer::base_and_crossings};
}

}  // namespace crest
