#pragma once

#include <array>
#include <functional>
#include <glm/vec3.hpp>

#include "render/resources/keyed_cache.h"
#include "render/volume/clip.h"

namespace crest {

/// The volume's values in 256 buckets, each with the box around all cells that have values in it (VDLS,
/// section 4.1). A cell counts for each bucket from its least corner to its greatest: a bucket by the voxels'
/// own values, as published, misses what interpolation makes between them. They depend on the volume alone.
struct HomoRegions {
  static constexpr int buckets = 256;
  struct Region {
    glm::ivec3 first{1}, last{0};  ///< grid points, both included; last < first where the bucket is empty
  };
  ValueRange range;  ///< of the field
  std::array<Region, buckets> regions;

  /// The values of a bucket.
  ValueRange values_of(int bucket) const;
};

/// A volume without empty cells.
HomoRegions find_homo_regions(const Volume& volume);

/// The same, held.
const HomoRegions& homo_regions(KeyedCache& held, const std::shared_ptr<const Volume>& volume);

/// The box around all regions of which `is_visible(values)` holds, in world units: the proxy for space
/// leaping. Empty where none is.
Box visible_box(const HomoRegions& homo, const Grid& grid,
                const std::function<bool(ValueRange values)>& is_visible);

}  // namespace crest
