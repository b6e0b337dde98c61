#pragma once

#include "ui/studio_state.h"

namespace crest {

/// "Choose for me": has a setting chosen that keeps the Accuracy panel's target, and tells what came of it.
void choice_rows(const Document& document, StudioState& state, const StudioInputs& inputs,
                 StudioRequests& requests);

/// What was chosen and why, and what is foretold of it; beside that what the Accuracy panel has measured of
/// the same setting. Empty where nothing was chosen.
std::string choice_text(const ChoiceResults& choice, const AccuracyResults* accuracy);

}  // namespace crest
