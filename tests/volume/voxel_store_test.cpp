#include "render/volume/voxel_store.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <vector>

namespace crest {
namespace {

TEST(VoxelStore, TakesOneSampleOfEachPoint) {
  const GridPart part = whole_grid({2, 2, 2});
  VoxelStore store(ScalarType::uint8, part.point_count(), LinearMap());
  std::vector<std::byte> slice;
  for (int i = 0; i < 8; ++i) slice.push_back(std::byte(i));
  const auto put = [&](std::uint64_t index, std::span<const std::byte> bytes) {
    put_slice(store, part, 1, bytes, ScalarType::uint8, {2, index}, {});
  };
  put(1, slice);
  EXPECT_THROW(put(2, slice), std::out_of_range);
  EXPECT_THROW(put(0, std::span(slice).first(7)), std::out_of_range);
  const Voxels voxels = store.take();
  for (std::size_t i = 0; i < 8; ++i) EXPECT_EQ(voxels[i], i < 4 ? 0.f : float(2 * (i - 4) + 1));
}

}  // namespace
}  // namespace crest
