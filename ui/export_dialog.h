#pragma once

#include "ui/studio_state.h"

namespace crest {

/// The window that writes the preset for another program: the formats, what each loses, and on demand the
/// present view as the target will draw it.
void export_dialog(const Document& document, StudioState& state, const StudioInputs& inputs,
                   StudioRequests& requests);

}  // namespace crest
