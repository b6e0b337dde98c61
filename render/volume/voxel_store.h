#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "render/volume/convert.h"
#include "render/volume/grid_part.h"
#include "render/volume/rounding.h"
#include "render/volume/voxels.h"

namespace crest {

/// Whether values of a type stay as they are stored.
bool is_kept_as_stored(ScalarType type);
/// Bytes that Voxels take of a value of this type.
std::size_t held_size_of(ScalarType type);

/// `count` values of a type that is kept as it is stored, or of float32: zeros, to be filled.
Voxels::Stored make_stored(ScalarType type, std::size_t count);

/// The values of a grid while they are read: integers of 8 and 16 bits stay as they are stored, others become
/// float32.
class VoxelStore {
 public:
  /// `map`: of all values, which are of this type. Where there is none, as they differ, all become float32.
  VoxelStore(ScalarType type, std::size_t count, std::optional<LinearMap> map);
  /// Takes `count` values of a type, `stride` values apart in `bytes`, for those from `first` on; `map` is
  /// theirs. Any thread may, for other values.
  void put(std::size_t first, std::size_t count, std::span<const std::byte> bytes, ScalarType type,
           std::size_t stride, LinearMap map);
  Voxels take() { return {std::move(stored_), map_}; }

 private:
  Voxels::Stored stored_;
  LinearMap map_;
};

/// Of the samples that each point has, one.
struct SampleOf {
  std::uint64_t count = 1, index = 0;
};
/// Puts slice k of a part of a grid, from the bytes of a whole slice of it, x fastest, a point's samples
/// together. What 32-bit float loses of those that are taken. Throws std::out_of_range for bytes without
/// them.
Rounding put_slice(VoxelStore& store, const GridPart& part, std::uint64_t k, std::span<const std::byte> bytes,
                   ScalarType type, SampleOf sample, LinearMap map);

}  // namespace crest
