#include "render/volume/largest_change.h"

#include <gtest/gtest.h>

#include <random>

#include "tests/raycaster/reconstruct.h"

namespace crest {
namespace {

const FieldFilter filters[] = {{Filter::linear},
                               {Filter::bspline},
                               {Filter::bc, 0, 0.5},
                               {Filter::bc, 2, 1},
                               {Filter::bc, 1.0 / 3, 1.0 / 3},
                               {Filter::bc, -2, 1.5}};

Volume volume_of(const std::function<double(glm::ivec3)>& value) {
  Volume volume;
  volume.grid = {{7, 6, 8}, {1, 0.5, 1.5}, {0, 0, 0}};
  for (int k = 0; k < 8; ++k)
    for (int j = 0; j < 6; ++j)
      for (int i = 0; i < 7; ++i) volume.values.floats().push_back(float(value({i, j, k})));
  volume.statistics = compute_statistics(volume.grid, volume.values);
  return volume;
}

// Of pairs of places in volumes of 0 and 1, whose neighbours differ as much as they can.
TEST(LargestChange, IsNeverExceeded) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> unit(0, 1);
  for (const FieldFilter& filter : filters)
    for (int round = 0; round < 20; ++round) {
      const Volume volume = volume_of([&](glm::ivec3) { return random() % 2; });
      const glm::dvec3 box = volume.grid.box_size() / volume.grid.smallest_spacing();
      for (int pair = 0; pair < 50; ++pair) {
        const glm::dvec3 a = box * glm::dvec3(unit(random), unit(random), unit(random));
        const double length = std::pow(10.0, -3 * unit(random));
        const glm::dvec3 direction(unit(random) - 0.5, unit(random) - 0.5, unit(random) - 0.5);
        const glm::dvec3 b = glm::clamp(a + length * glm::normalize(direction), glm::dvec3(0), box);
        const double change =
            std::abs(testing::reconstruct(volume, filter, a) - testing::reconstruct(volume, filter, b));
        EXPECT_LE(change, largest_change(volume.grid, volume.statistics, filter,
                                         glm::distance(a, b) * volume.grid.smallest_spacing()));
      }
    }
}

// A ramp changes by its slope, of which the bound must not be far.
TEST(LargestChange, IsNearForARamp) {
  const Volume volume = volume_of([](glm::ivec3 p) { return p.x; });
  for (const Filter kind : {Filter::linear, Filter::bspline}) {
    const double change = largest_change(volume.grid, volume.statistics, {kind}, 1);
    EXPECT_GE(change, 1);
    EXPECT_LE(change, 1.01);
  }
}

}  // namespace
}  // namespace crest
