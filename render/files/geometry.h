#pragma once

#include "render/volume/volume.h"

namespace crest {

/// Makes what a file says of its grid one that the renderer can use - spacing positive and finite, origin and
/// direction finite - and says so in the note.
void repair_geometry(Volume& volume);

}  // namespace crest
