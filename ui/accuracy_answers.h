#pragma once

#include <string>

#include "ui/accuracy_shown.h"

namespace crest {

/// The mode, and so the view, that an answer is of.
Mode mode_of(Answer answer);

/// Whose answer is shown, and how far it lies from the integral of the whole TF, in words.
std::string model_text(const ShownAccuracy& shown);

/// The choice of the answer against which errors are shown; each button tells which view it is of.
void answer_rows(StudioState& state, const ShownAccuracy& shown);

}  // namespace crest
