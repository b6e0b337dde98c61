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
