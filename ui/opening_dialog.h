#pragma once

#include "ui/studio_state.h"

namespace crest {

/// The window that asks what a volume's file leaves open: which component, frame or series, how its raw
/// voxels lie (raw_form.h), or what part of it fits the memory (part_form.h). What is chosen is opened.
void opening_dialog(StudioState& state, const StudioInputs& inputs, StudioRequests& requests);

}  // namespace crest
