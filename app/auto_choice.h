#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "app/options.h"
#include "app/scene_options.h"
#include "render/measure/choose_setting.h"

namespace crest {

/// --target-error's MEASURE=NUMBER. Throws UsageError.
TargetError target_option(const std::string& text);

/// `render`'s options that have the setting chosen.
struct AutoOptions {
  bool is_on = false;
  std::string target, budget;  ///< as typed; empty where not given

  void add_to(Options options);
  /// Throws UsageError where one is wrong, or is given without --auto, or beside what --auto chooses.
  void check(const SceneOptions& scene) const;
  ChoiceSettings settings() const;  ///< throws UsageError
};

/// What was chosen, in a line for people. `measured_ms` is a frame's, drawn with it.
std::string choice_line(const Choice& choice, const TargetError& target, double measured_ms);
/// The same for programs, with all that was tried. Numbers that are not known are null.
nlohmann::ordered_json choice_json(const Choice& choice, const ChoiceSettings& settings);

}  // namespace crest
