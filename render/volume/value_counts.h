#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "render/volume/volume.h"

namespace crest {

/// How often each value is there, of values that are stored in 8 or 16 bits: in the order of the stored ones,
/// all that the type has. All else that does not depend on places follows from it, without a voxel being
/// looked at again, and without rounding but its own.
using ValueCounts = std::vector<std::uint64_t>;

ValueCounts no_counts(const Voxels& values);
/// Counts `count` values from `first` on, on this thread.
void add_counts(const Voxels& values, std::size_t first, std::size_t count, ValueCounts& counts);
/// Adds those of a part to the whole's: of values, or of bins.
void add_to(ValueCounts& whole, const ValueCounts& part);
/// Of all values, on all cores.
ValueCounts count_values(const Voxels& values);

/// The range, the mean, the variance and how many are infinite.
void summarize(const Voxels& values, const ValueCounts& counts, VolumeStatistics& statistics);
/// As histogram_of().
std::vector<std::uint64_t> histogram_of(const Voxels& values, const ValueCounts& counts, ValueRange range,
                                        int bins);

}  // namespace crest
