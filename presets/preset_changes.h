#pragma once

#include <string>
#include <vector>

#include "presets/preset.h"

namespace crest {

/// What a person would have to do to make one preset of another, a short sentence for each thing: "Move 3
/// points", "Change step from 0.5 to 0.25". The transfer function comes first, the camera last. Empty where
/// the two are equal, but for keys of a file that this version does not know.
std::vector<std::string> preset_changes(const Preset& before, const Preset& after);

}  // namespace crest
