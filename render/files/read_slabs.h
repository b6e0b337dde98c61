#pragma once

#include <bit>
#include <cstddef>
#include <functional>
#include <span>

#include "render/files/voxel_layout.h"
#include "render/volume/convert.h"
#include "render/volume/rounding.h"
#include "render/volume/tell_share.h"
#include "render/volume/voxels.h"

namespace crest {

/// What stored values are.
struct StoredAs {
  ScalarType type = ScalarType::float32;
  std::endian endian = std::endian::native;
  LinearMap map;  ///< from the stored values to the volume's
};

/// Fills `out` with the bytes of the stored values from `first` on. A later call asks for later values.
using ReadValues = std::function<void(std::uint64_t first, std::span<std::byte> out)>;

/// Bytes that read_slabs() holds at once beside what it returns, where no two points lie further apart.
inline constexpr std::uint64_t slab_bytes = std::uint64_t(8) << 20;

struct SlabsRead {
  Voxels values;      ///< x fastest
  Rounding rounding;  ///< of those that become float32
};

/// The values of a layout with one component and one frame: read slab by slab along the axis that is the
/// slowest in the file, and what lies between slabs is not asked for.
SlabsRead read_slabs(const VoxelLayout& layout, const StoredAs& stored, const ReadValues& read,
                     const TellShare& progress = {});

}  // namespace crest
