#pragma once

#include "render/volume/filter.h"
#include "render/volume/volume.h"

namespace crest {

/// A field's values at two places no further apart than `length`, in world units, differ by no more than
/// this on any graphics device.
double largest_change(const Grid& grid, const VolumeStatistics& statistics, const FieldFilter& filter,
                      double length);

}  // namespace crest
