#pragma once

#include <string>
#include <vector>

#include "ui/document.h"

namespace crest {

/// What led from one document to the other, in one short sentence: "Move 3 points", "Open onion.json", "Take
/// setting peak finding, XOR at step 1/8", "Change mode from both to DVR_ONLY and 2 more changes".
std::string describe_step(const Document& before, const Document& after);

/// All that differs from the preset as it was saved, a sentence each, but for the camera.
std::vector<std::string> changes_since(const Preset& saved, const Preset& now);

}  // namespace crest
