#include "app/report/studies.h"

#include "app/report/knoll_study.h"
#include "app/report/placement_study.h"
#include "app/report/random_study.h"
#include "app/report/vdls_study.h"

namespace crest {

std::span<const Study> studies() {
  static constexpr Study table[] = {
      {"placement", "where a ray's samples lie (Steneteg et al.), of VOLUME or a built-in",
       run_placement_study, true},
      {"knoll", "peak finding's tables, figures and claims (Knoll et al. 2009) again", run_knoll_study, false,
       true},
      {"vdls", "view-dependent layer sampling beside the ray caster", run_vdls_study, false, true},
      {"random", "every method on twelve random scenes (--seed) against the exact answers", run_random_study,
       false, true, true},
  };
  return table;
}

}  // namespace crest
