#pragma once

#include "ui/studio_state.h"

namespace crest {

/// The list of peaks: values, switches, and a click that selects the peak's points. Returns whether it
/// changed the document.
bool peaks_panel(Document& document, StudioState& state, const StudioInputs& inputs, float height);

}  // namespace crest
