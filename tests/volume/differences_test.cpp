#include <gtest/gtest.h>

#include <cfloat>
#include <cmath>
#include <glm/glm.hpp>

#include "render/volume/empty_cells.h"
#include "render/volume/random.h"
#include "render/volume/volume.h"

namespace crest::test {
namespace {

/// A volume of noise of any shape, some of it without values.
Volume random_volume(Random& random) {
  Volume volume;
  for (int axis = 0; axis < 3; ++axis) {
    volume.grid.dims[axis] = int(random.uniform(2, 9));
    volume.grid.spacing[axis] = std::pow(10, random.uniform(-3, 3));
  }
  const double holes = random.uniform(-0.2, 0.2), scale = std::pow(10, random.uniform(-30, 30));
  for (std::size_t i = 0; i < volume.grid.point_count(); ++i) {
    const bool hole = random.uniform(0, 1) < holes;
    volume.values.floats().push_back(hole ? (i % 2 ? NAN : INFINITY) : float(random.uniform(-scale, scale)));
  }
  volume.statistics = compute_statistics(volume.grid, volume.values);
  return volume;
}

TEST(Differences, AreThoseOfFiniteNeighbours) {
  Random random(5);
  for (int trial = 0; trial < 300; ++trial) {
    const Volume volume = random_volume(random);
    const glm::ivec3 dims = volume.grid.dims;
    glm::dvec3 largest(0);
    for (int k = 0; k < dims.z; ++k)
      for (int j = 0; j < dims.y; ++j)
        for (int i = 0; i < dims.x; ++i)
          for (int axis = 0; axis < 3; ++axis) {
            glm::ivec3 next(i, j, k);
            if (++next[axis] == dims[axis]) continue;
            const double a = volume.at(i, j, k), b = volume.at(next.x, next.y, next.z);
            if (std::isfinite(a) && std::isfinite(b))
              largest[axis] = std::max(largest[axis], std::abs(b - a));
          }
    EXPECT_EQ(volume.statistics.largest_difference, largest);
  }
}

TEST(Differences, EmptyCellsLieInTheirPart) {
  Random random(6);
  int with_holes = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const Volume volume = random_volume(random);
    const std::vector<std::uint8_t> empty = find_empty_cells(volume);
    const glm::ivec3 cells = volume.grid.dims - 1;
    glm::ivec3 low = volume.grid.dims, high(-1);
    for (int k = 0, index = 0; k < cells.z; ++k)
      for (int j = 0; j < cells.y; ++j)
        for (int i = 0; i < cells.x; ++i, ++index)
          if (empty[std::size_t(index)]) {
            low = glm::min(low, glm::ivec3(i, j, k));
            high = glm::max(high, glm::ivec3(i, j, k) + 1);
          }
    const bool none = high.x < 0;
    with_holes += !none;
    EXPECT_EQ(volume.statistics.empty_max.x < volume.statistics.empty_min.x, none);
    if (none) continue;
    EXPECT_EQ(volume.statistics.empty_min, low);
    EXPECT_EQ(volume.statistics.empty_max, high);
  }
  EXPECT_GT(with_holes, 50);
}

// The slope between two places in a cell is never beyond the bound, and on a ramp along a cell's diagonal it
// is the bound.
TEST(Differences, BoundTheTrilinearGradient) {
  Random random(7);
  for (int trial = 0; trial < 2000; ++trial) {
    double corners[8];
    Volume volume;
    for (int axis = 0; axis < 3; ++axis) volume.grid.spacing[axis] = random.uniform(0.1, 3);
    for (double& corner : corners) {
      volume.values.floats().push_back(float(random.uniform(0, 1)));
      corner = double(volume.values.floats().back());
    }
    volume.statistics = compute_statistics(volume.grid, volume.values);
    const auto field = [&](glm::dvec3 p) {
      const auto x = [&](int c) { return corners[c] + p.x * (corners[c + 1] - corners[c]); };
      const double low = x(0) + p.y * (x(2) - x(0)), high = x(4) + p.y * (x(6) - x(4));
      return low + p.z * (high - low);
    };
    const auto place = [&] {
      return glm::dvec3(random.uniform(0, 1), random.uniform(0, 1), random.uniform(0, 1));
    };
    const glm::dvec3 a = place(), b = place();
    EXPECT_LE(std::abs(field(b) - field(a)), largest_gradient(volume.grid, volume.statistics) *
                                                 glm::length((b - a) * volume.grid.spacing) * (1 + 1e-12));
  }
  const Grid ramp{{2, 2, 2}, {1, 2, 4}, {0, 0, 0}};
  const std::vector<float> values{0, 3, 8, 11, 48, 51, 56, 59};  // 3x + 4y + 12z
  EXPECT_DOUBLE_EQ(largest_gradient(ramp, compute_statistics(ramp, values)), 13);
}

TEST(Differences, OfExtremes) {
  const Grid pair{{2, 2, 2}, glm::dvec3(1), glm::dvec3(0)};
  const std::vector<float> extreme{-FLT_MAX, FLT_MAX, 0, 0, NAN, INFINITY, -INFINITY, 0};
  const VolumeStatistics s = compute_statistics(pair, extreme);
  EXPECT_EQ(s.largest_difference, glm::dvec3(2.0 * double(FLT_MAX), FLT_MAX, 0));
  EXPECT_EQ(s.empty_min, glm::ivec3(0));
  EXPECT_EQ(s.empty_max, glm::ivec3(1));
  const VolumeStatistics nothing = compute_statistics(pair, std::vector<float>(8, NAN));
  EXPECT_EQ(nothing.largest_difference, glm::dvec3(0));
}

}  // namespace
}  // namespace crest::test
