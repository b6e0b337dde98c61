#pragma once

#include <utility>

#include "ui/document.h"
#include "ui/shown_values.h"
#include "ui/studio_state.h"

namespace crest {

/// Lets `edit` change the document's TF in the values that the editor shows (edit_shown).
template <class Edit>
bool in_shown_values(Document& document, StudioState& state, const StudioInputs& inputs, Edit&& edit) {
  return edit_shown(document.preset.transfer_function, state.settings,
                    inputs.volume ? &inputs.volume->statistics.range : nullptr, state.editor.shown_curve,
                    std::forward<Edit>(edit));
}

}  // namespace crest
