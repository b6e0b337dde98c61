#pragma once

#include "ui/studio_state.h"

namespace crest {

/// Whether an error is to be told.
bool has_error(const StudioInputs& inputs);

/// Over what lies at `corner`, `width` pixels wide: the last error, until the person closes it. Nothing moves
/// aside for it.
void error_banner(StudioState& state, const StudioInputs& inputs, StudioRequests& requests, ImVec2 corner,
                  float width);

/// Esc closes it, before anything else that Esc is for.
void close_error_by_key(StudioState& state, const StudioInputs& inputs, StudioRequests& requests);

}  // namespace crest
