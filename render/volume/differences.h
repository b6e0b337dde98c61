#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "render/volume/volume.h"

// The statistics that need to know which values are neighbours. `values` are those of the grid's points, x
// fastest.

namespace crest {

/// VolumeStatistics::largest_difference.
glm::dvec3 largest_differences(const Grid& grid, const Voxels& values);

/// Grid points, both ends included.
struct PointBox {
  glm::ivec3 min{0}, max{-1};
};
/// VolumeStatistics::empty_min and empty_max, of a grid in which a value is NaN or infinite.
PointBox empty_part(const Grid& grid, const Voxels& values);

}  // namespace crest
