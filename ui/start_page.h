#pragma once

#include "ui/studio_state.h"

namespace crest {

/// What a person sees where no volume is open, in place of the views: what can be opened.
void start_page(const Document& document, StudioState& state, const StudioInputs& inputs,
                StudioRequests& requests);

}  // namespace crest
