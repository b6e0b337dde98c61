#include "app/report/studies.h"

#include "app/report/placement_study.h"
#include "app/report/vdls_study.h"

namespace crest {

std::span<const Study> studies() {
  static constexpr Study table[] = {
      {"placement", "where a ray's samples lie (Steneteg et al.), of VOLUME or a built-in",
       run_placement_study, false, true},
      {"vdls",
       "view-dependent layer sampling beside the ray caster, of volumes in the folder VOLUME or built-in "
       "ones",
       run_vdls_study, true, true},
  };
  return table;
}

}  // namespace crest
