#include "render/volume/macrocells.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <random>

namespace crest {
namespace {

Volume random_volume(glm::ivec3 dims, std::mt19937& random) {
  Volume volume;
  volume.grid.dims = dims;
  for (std::size_t i = 0; i < volume.grid.point_count(); ++i)
    volume.values.floats().push_back(std::uniform_real_distribution<float>(-1, 1)(random));
  return volume;
}

/// The field at a place within a cell, from the points that the filter reaches.
double field_at(const Volume& volume, const FieldFilter& filter, glm::dvec3 place) {
  const glm::ivec3 last = volume.grid.dims - 1;
  const glm::ivec3 cell = glm::clamp(glm::ivec3(glm::floor(place)), glm::ivec3(0), last - 1);
  const glm::dvec3 u = place - glm::dvec3(cell);
  const auto weights = filter_weights(filter);
  const auto weight = [&](int i, double x) {
    const CubicWeight& w = weights[std::size_t(i)];
    return w[0] + x * (w[1] + x * (w[2] + x * w[3]));
  };
  double sum = 0;
  for (int k = 0; k < 4; ++k)
    for (int j = 0; j < 4; ++j)
      for (int i = 0; i < 4; ++i) {
        const glm::ivec3 p = glm::clamp(cell + glm::ivec3(i, j, k) - 1, glm::ivec3(0), last);
        sum += weight(i, u.x) * weight(j, u.y) * weight(k, u.z) * double(volume.at(p.x, p.y, p.z));
      }
  return sum;
}

TEST(Macrocells, BoundTheFieldOfEveryFilter) {
  std::mt19937 random(7);
  for (const FieldFilter filter : {FieldFilter{Filter::linear, 0, 0}, FieldFilter{Filter::bspline, 0, 0},
                                   FieldFilter{Filter::bc, 0, 0.5}, FieldFilter{Filter::bc, 2, 1}}) {
    const Volume volume = random_volume({11, 6, 9}, random);
    for (const int side : {1, 3, 4, 20}) {
      const Macrocells macrocells = build_macrocells(volume, filter, side);
      ASSERT_EQ(macrocells.dims, (glm::ivec3(10, 5, 8) + side - 1) / side);
      for (int trial = 0; trial < 2000; ++trial) {
        const glm::dvec3 place =
            glm::dvec3(random() % 1001, random() % 1001, random() % 1001) / 1000.0 * glm::dvec3(10, 5, 8);
        const glm::ivec3 cell = glm::min(glm::ivec3(place) / side, macrocells.dims - 1);
        const auto index = std::size_t(cell.x + macrocells.dims.x * (cell.y + macrocells.dims.y * cell.z));
        const double field = field_at(volume, filter, place);
        EXPECT_GE(field, double(macrocells.min[index]) - 1e-6);
        EXPECT_LE(field, double(macrocells.max[index]) + 1e-6);
      }
    }
  }
}

// Stored integers are summed as they are: what is found is that of the same values as floats.
TEST(Macrocells, OfStoredIntegersAreThoseOfFloats) {
  std::mt19937 random(8);
  for (const LinearMap map : {LinearMap(), LinearMap{-2, 30}, LinearMap{0.3, -1}, LinearMap{1e34, 0}}) {
    Volume stored;
    stored.grid.dims = {20, 11, 13};
    std::vector<std::int16_t> values(stored.grid.point_count());
    for (auto& value : values) value = std::int16_t(random() & 0xFFFF);
    stored.values = Voxels(Voxels::Stored(values), map);
    stored.statistics = compute_statistics(stored.grid, stored.values);
    Volume floats = stored;
    floats.values = stored.values.to_floats();
    for (const FieldFilter filter : {FieldFilter{Filter::linear, 0, 0}, FieldFilter{Filter::bspline, 0, 0}}) {
      const Macrocells a = build_macrocells(stored, filter, 3), b = build_macrocells(floats, filter, 3);
      EXPECT_EQ(a.min, b.min) << map.slope;
      EXPECT_EQ(a.max, b.max) << map.slope;
      for (std::size_t i = 0; i < a.count(); ++i)
        EXPECT_NEAR(a.deviation[i], b.deviation[i], 1e-6 * b.deviation[i]) << map.slope;
    }
  }
}

TEST(Macrocells, KnowTheirOwnPointsDeviation) {
  std::mt19937 random(3);
  Volume volume = random_volume({9, 5, 5}, random);
  volume.values.floats()[0] = NAN;
  const Macrocells macrocells = build_macrocells(volume, {}, 4);
  ASSERT_EQ(macrocells.count(), 2u);
  for (int cell = 0; cell < 2; ++cell) {
    double sum = 0, squares = 0;
    int count = 0;
    for (int k = 0; k < 5; ++k)
      for (int j = 0; j < 5; ++j)
        for (int i = 4 * cell; i <= 4 * cell + 4; ++i)
          if (const double value = double(volume.at(i, j, k)); std::isfinite(value)) {
            sum += value;
            ++count;
          }
    for (int k = 0; k < 5; ++k)
      for (int j = 0; j < 5; ++j)
        for (int i = 4 * cell; i <= 4 * cell + 4; ++i)
          if (const double value = double(volume.at(i, j, k)); std::isfinite(value))
            squares += (value - sum / count) * (value - sum / count);
    EXPECT_NEAR(macrocells.deviation[std::size_t(cell)], std::sqrt(squares / count), 1e-6);
  }
}

TEST(Macrocells, WithoutAValueAreEmpty) {
  Volume volume;
  volume.grid.dims = {9, 5, 5};
  volume.values.floats().assign(volume.grid.point_count(), 1.0f);
  for (int k = 0; k < 5; ++k)
    for (int j = 0; j < 5; ++j)
      for (int i = 4; i < 9; ++i) volume.values.floats()[std::size_t(i + 9 * (j + 5 * k))] = INFINITY;
  const Macrocells macrocells = build_macrocells(volume, {}, 4);
  EXPECT_LE(macrocells.min[0], macrocells.max[0]);
  EXPECT_GT(macrocells.min[1], macrocells.max[1]);
}

TEST(Macrocells, AreSmallerWhereMostIsBackground) {
  VolumeStatistics varied, sparse;
  varied.histogram = {10, 20, 20, 50};
  sparse.histogram = {10, 20, 20, 51};
  for (const int n : {2, 5, 64, 128, 257, 302, 1000}) {
    const Grid grid{{n, 2, 2}};
    const auto count = [&](int side) { return (n - 1 + side - 1) / side; };
    const int side = macrocell_side(grid, varied), smaller = macrocell_side(grid, sparse);
    EXPECT_GE(side, 4);
    EXPECT_LE(count(side), 64) << n;
    EXPECT_GE(smaller, 2);
    EXPECT_LT(smaller, side);
    EXPECT_LE(count(smaller), 96) << n;
  }
  EXPECT_EQ(macrocell_side(Grid{{9, 9, 9}}, {}), 4);
}

}  // namespace
}  // namespace crest
