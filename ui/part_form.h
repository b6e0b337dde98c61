#pragma once

#include "ui/studio_state.h"

namespace crest {

/// The smallest stride that fits, and a box in the middle that does.
void begin_part_form(OpeningState& opening, const OpenChoice& choice);

/// The form for a volume that is too large: every n-th point of it, or a box, with what either needs. Returns
/// whether that can be opened.
bool part_form(StudioState& state, const OpenChoice& choice);

/// The source with the chosen part.
std::string source_with_part(const OpeningState& opening, const OpenChoice& choice);

}  // namespace crest
