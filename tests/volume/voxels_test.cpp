#include "render/volume/voxels.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace crest {
namespace {

template <class Integer>
std::vector<Integer> all_of() {
  std::vector<Integer> all;
  for (int i = std::numeric_limits<Integer>::min(); i <= std::numeric_limits<Integer>::max(); ++i)
    all.push_back(Integer(i));
  return all;
}

TEST(Voxels, AreTheMappedIntegersRoundedOnce) {
  const LinearMap map{0.1, -1024.3};
  const Voxels voxels(all_of<std::int16_t>(), map);
  EXPECT_EQ(voxels.byte_count(), 2 * voxels.size());
  for (std::size_t i = 0; i < voxels.size(); ++i)
    ASSERT_EQ(voxels[i], float((double(i) - 32768) * map.slope + map.intercept)) << i;
}

TEST(Voxels, OfEachTypeAreReadInPartsAsOneByOne) {
  std::vector<float> room;
  for (const LinearMap map : {LinearMap{}, LinearMap{-0.5, 3}})
    for (const Voxels& voxels : {Voxels(all_of<std::uint8_t>(), map), Voxels(all_of<std::int8_t>(), map),
                                 Voxels(all_of<std::uint16_t>(), map), Voxels(all_of<std::int16_t>(), map)}) {
      const std::span<const float> part = voxels.part(7, 100, room);
      ASSERT_EQ(part.size(), 100u);
      for (std::size_t i = 0; i < 100; ++i) EXPECT_EQ(part[i], voxels[7 + i]);
      EXPECT_EQ(Voxels(voxels.to_floats()), voxels);
      EXPECT_EQ(voxels, Voxels(voxels.to_floats()));
    }
}

TEST(Voxels, OfFloatsAreReadWhereTheyAre) {
  const Voxels voxels(std::vector<float>{1, 2, 3});
  std::vector<float> room;
  EXPECT_EQ(voxels.part(1, 2, room).data(), static_cast<const float*>(voxels.data()) + 1);
  EXPECT_TRUE(room.empty());
}

TEST(Voxels, AreSharedByCopiesUntilOneIsChanged) {
  Voxels voxels(std::vector<float>{1, 2, 3});
  const Voxels copy = voxels;
  EXPECT_EQ(copy.data(), voxels.data());
  voxels.floats()[1] = 7;
  EXPECT_EQ(copy, Voxels(std::vector<float>{1, 2, 3}));
  EXPECT_EQ(voxels, Voxels(std::vector<float>{1, 7, 3}));
  const void* alone = voxels.data();
  voxels.floats()[0] = 8;
  EXPECT_EQ(voxels.data(), alone) << "nobody else holds it";
  const Voxels taken = std::move(voxels);
  EXPECT_EQ(taken.data(), alone);
}

TEST(Voxels, AreFloatsOnceTheyAreChanged) {
  Voxels voxels(std::vector<std::uint8_t>{1, 2, 3}, {2, 1});
  const Voxels before = voxels;
  voxels.floats()[1] = std::nanf("");
  EXPECT_TRUE(voxels.are_floats());
  EXPECT_EQ(voxels[0], 3.f);
  EXPECT_TRUE(std::isnan(voxels[1]));
  EXPECT_EQ(voxels[2], 7.f);
  EXPECT_NE(voxels, before);
}

}  // namespace
}  // namespace crest
