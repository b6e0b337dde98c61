#pragma once

#include <string>

#include "render/measure/choose_setting.h"

namespace crest {

/// Why a setting was chosen, as a sentence without a full stop.
std::string why_chosen(const Choice& choice, const ChoiceSettings& settings);

}  // namespace crest
