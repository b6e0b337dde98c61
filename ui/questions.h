#pragma once

#include "ui/studio_state.h"

namespace crest {

/// The question about unsaved changes, once the person asked to quit; without any, it quits.
void quit_question(Document& document, StudioState& state, const StudioInputs& inputs,
                   StudioRequests& requests);

/// Opens the file dialog beside the document's preset or volume.
void ask_for_file(StudioState& state, const Document& document, FilePurpose purpose);

/// The file dialog, and what becomes of its answer.
void file_question(StudioState& state, StudioRequests& requests);

/// The list of keys and mouse actions.
void help_window(StudioState& state);

}  // namespace crest
