#include "render/measure/measurement.h"

#include <algorithm>

namespace crest {

std::string_view name_of(Why why) {
  switch (why) {
    case Why::coverage:
      return "coverage";
    case Why::target:
      return "target";
    case Why::front:
      return "front";
    case Why::rest:
      return "rest";
    case Why::dominated:
      return "dominated";
  }
  return "";
}

const ImageError* Measurement::error_against(const ExactAnswer& answer) const {
  const auto found = std::ranges::find(errors, answer, &AnswerError::answer);
  return found == errors.end() ? nullptr : &found->error;
}

}  // namespace crest
