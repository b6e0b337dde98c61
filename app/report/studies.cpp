#include "app/report/studies.h"

#include <fmt/core.h>

#include "app/report/knoll_study.h"
#include "app/report/placement_study.h"
#include "app/report/random_study.h"
#include "app/report/vdls_study.h"
#include "presets/error.h"
#include "presets/json.h"
#include "render/reference/reference.h"

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

void work_on_study(const StudyOptions& options, const std::function<void()>& work) {
  try {
    work();
  } catch (const Cancelled&) {
    throw Error(
        fmt::format("{}: stopped before the study was done; nothing is written", options.folder.string()));
  }
}

void print_study(const StudyOptions& options, const Json& json, const std::string& text) {
  fmt::print("{}", options.json ? print_json(json) : text);
}

}  // namespace crest
