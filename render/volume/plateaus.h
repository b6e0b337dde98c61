#pragma once

#include <vector>

#include "render/volume/volume.h"

namespace crest {

/// The values that regions have throughout, ascending: those of at least a thousandth of the cells, at all
/// eight corners. Of labels and masks, and of a background.
std::vector<float> find_plateaus(const Grid& grid, const Voxels& values);

}  // namespace crest
