#pragma once

#include "ui/studio_state.h"

namespace crest {

/// Above a view: what it shows, as a button that opens its menu; whether that may be off, what it costs, the
/// menu of comparisons, and a line that explains it. `index` is the view's.
void view_caption(int index, StudioState& state, const StudioInputs& inputs, const Preset& preset);

/// Chooses a preset beside the document's: snapshots, the library, the person's own, files opened last. True
/// when `content` was given one, or none again; a file dialog answers later, for `part`. To be called in a
/// menu.
bool other_preset_menu(StudioState& state, const StudioInputs& inputs, const Preset& preset,
                       ViewContent& content, ViewPart part);

}  // namespace crest
