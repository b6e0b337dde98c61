#include "app/report/studies.h"

#include "app/report/placement_study.h"

namespace crest {

std::span<const Study> studies() {
  static constexpr Study table[] = {
      {"placement", "where a ray's samples lie (Steneteg et al.), of VOLUME or a built-in",
       run_placement_study, true},
  };
  return table;
}

}  // namespace crest
