#pragma once

#include <optional>
#include <string>

#include "render/measure/choose_setting.h"

namespace crest {

/// How the choice of a setting stands, and what was chosen last.
struct ChoiceResults {
  bool is_running = false;
  std::string error;  ///< why nothing was chosen, in a sentence; empty where something was
  std::optional<Choice> chosen;
  TargetError target = default_target();  ///< that it was chosen for
};

}  // namespace crest
