#pragma once

#include "ui/studio_state.h"

namespace crest {

/// What the file says itself, and where that does not fit, the likeliest guess.
void begin_raw_form(OpeningState& opening, const Opening& asked);

/// The form for raw voxels: size, type, byte order, offset and spacing, checked against the file's length,
/// with sizes that fit and a slice. Asks for the slice; returns whether the volume can be opened.
bool raw_form(StudioState& state, const Opening& asked, StudioRequests& requests);

}  // namespace crest
