#pragma once

#include "ui/studio_state.h"

namespace crest {

/// The table of the volume's surfaces as a picture: entry value across, exit value up, a cell in the colour
/// of the peak that is met first. The mouse tells what a cell holds. The table is made here, so that it costs
/// nothing while the panel is not in sight.
void peak_table_panel(const Document& document, StudioState& state, const StudioInputs& inputs);

}  // namespace crest
