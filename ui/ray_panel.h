#pragma once

#include "ui/studio_state.h"

namespace crest {

/// One pixel's ray: what each mode makes of it, beside the exact answer.
void ray_panel(const Document& document, StudioState& state, const StudioInputs& inputs);

}  // namespace crest
