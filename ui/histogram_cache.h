#pragma once

#include <vector>

#include "render/volume/volume.h"

namespace crest {

/// Columns of the histogram that is drawn; at most so many.
inline constexpr int histogram_columns = 256;

/// The histogram behind the curve: counts in equal columns over `range`, in the volume's units. It is counted
/// anew only for another volume or another zoom.
struct HistogramCache {
  ValueRange range{0, 0};
  std::vector<std::uint64_t> counts;
  std::uint64_t largest = 0;

  const void* source = nullptr;  ///< the voxels that were counted
  ValueRange wanted{0, 0};       ///< what the last call asked for
};

/// Brings the cache up to date for the part of the axis that is in sight. A wide part comes from the volume's
/// own histogram; a narrow one is counted once the zoom is at rest, that is asked for twice.
void update_histogram(HistogramCache& cache, const Volume& volume, ValueRange visible);

}  // namespace crest
