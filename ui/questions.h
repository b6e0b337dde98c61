#pragma once

#include "ui/studio_state.h"

namespace crest {

/// Holds back what would lose unsaved changes - to quit, a new preset, another one - until the person
/// answered a question about them; without any, lets it pass. To be called when all that may ask for it has
/// been drawn.
void unsaved_question(Document& document, StudioState& state, const StudioInputs& inputs,
                      StudioRequests& requests);

/// Holds back quitting while a picture is being saved: the window says so, and quits when it is done. To be
/// called after unsaved_question().
void saving_question(StudioState& state, const StudioInputs& inputs, StudioRequests& requests);

/// Of a window that asks something.
void center_next_window();

/// Opens the window of this name, for something to be asked, unless it is open; it waits until nothing else
/// is, for it would close that.
void open_when_free(const char* title);

/// Opens the file dialog beside the document's preset or volume.
void ask_for_file(StudioState& state, const Document& document, FilePurpose purpose);

/// The file dialog, and what becomes of its answer.
void file_question(StudioState& state, StudioRequests& requests);

}  // namespace crest
