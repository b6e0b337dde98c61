#pragma once

#include "render/volume/volume.h"

namespace crest {

/// Makes the geometry of a whole grid that of a part: the volume remembers it, its note says it, and each
/// point stays where it is, in the grid's axes. The values are not touched.
void take_part(Volume& volume, const GridPart& part);

/// The grid that the volume is a part of, or its own.
Grid full_grid(const Volume& volume);

}  // namespace crest
