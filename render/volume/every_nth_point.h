#pragma once

#include <optional>
#include <vector>

#include "render/volume/volume.h"

namespace crest {

/// Every stride-th point on each axis, from the first one on; with the statistics of the whole. Throws Error
/// where fewer than 2 points are left on an axis.
Volume every_nth_point(const Volume& volume, int stride);

/// How much of the surfaces at `values` is left when the volume is thinned: the mean area of the isosurfaces
/// in the bin of by_value.h that holds the value, by that of the whole. About 1 where surfaces are smooth at
/// the stride, less where they are thinner or rougher than it, or cut off at the box's far faces. Nothing
/// where the whole has no surface.
std::vector<std::optional<double>> surface_left(const Volume& volume, int stride,
                                                const std::vector<double>& values);

}  // namespace crest
