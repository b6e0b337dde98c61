#pragma once

#include <cstdint>
#include <vector>

#include "render/volume/filter_bounds.h"
#include "render/volume/volume.h"

namespace crest {

/// Blocks of a grid's cells, with what the field has in each (Knoll et al. 2009, section 6.1). Those at the
/// far sides may be smaller.
struct Macrocells {
  int cells = 1;       ///< of the grid, along each side of a macrocell
  glm::ivec3 dims{0};  ///< macrocells on each axis
  /// Of the field that the filter makes, x fastest; max < min where no voxel has a value.
  std::vector<float> min, max;
  /// Standard deviation of the macrocell's own voxels; 0 where there are none.
  std::vector<float> deviation;

  std::size_t count() const { return min.size(); }
};

/// Cells along the side of a macrocell: as small as pays, since a walk through them costs some samples a
/// macrocell. At least 4 and at most 64 on the longest axis, as in the paper; where most voxels have nearly
/// the same value there is much to skip, and it is 2 and 96 (docs/measured.md).
int macrocell_side(const Grid& grid, const VolumeStatistics& statistics);

/// Macrocells of this side on each axis.
inline glm::ivec3 macrocell_dims(const Grid& grid, int side) { return (grid.dims - 2 + side) / side; }

/// O(voxels), on all cores. Voxels without a value do not count: no sample lies in their cells.
Macrocells build_macrocells(const Volume& volume, const FieldFilter& filter, int side);

}  // namespace crest
