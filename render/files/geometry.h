#pragma once

#include "render/volume/volume.h"

namespace crest {

/// Makes what a file says of its grid one that the renderer can use - spacing positive and finite, origin and
/// direction finite - and says so in the note.
void repair_geometry(Volume& volume);

/// repair_geometry() of the whole grid, then take_part().
void place_part(Volume& volume, const GridPart& part);

}  // namespace crest
