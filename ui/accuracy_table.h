#pragma once

#include "ui/accuracy_shown.h"

namespace crest {

/// The methods with their orders of convergence and their cheapest settings that meet the target, which a
/// click on a row takes. Returns whether the document changed.
bool accuracy_table(Document& document, StudioState& state, const ShownAccuracy& shown);

}  // namespace crest
