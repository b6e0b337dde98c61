#include <gtest/gtest.h>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <limits>
#include <map>
#include <type_traits>

#include "render/volume/random.h"
#include "render/volume/volume.h"

// All statistics are taken in one pass over the values as they are stored. Here they are held against the
// plain forms, which look at each float in turn.

namespace crest::test {
namespace {

/// Calls visit(place, index) for each point.
template <class Visit>
void for_each_point(glm::ivec3 dims, const Visit& visit) {
  std::size_t index = 0;
  for (int k = 0; k < dims.z; ++k)
    for (int j = 0; j < dims.y; ++j)
      for (int i = 0; i < dims.x; ++i) visit(glm::ivec3(i, j, k), index++);
}

void add_differences(const Grid& grid, const std::vector<float>& v, VolumeStatistics& s) {
  const std::size_t apart[] = {1, std::size_t(grid.dims.x),
                               std::size_t(grid.dims.x) * std::size_t(grid.dims.y)};
  for_each_point(grid.dims, [&](glm::ivec3 place, std::size_t i) {
    for (int axis = 0; axis < 3; ++axis) {
      if (place[axis] + 1 == grid.dims[axis]) continue;
      const double a = v[i], b = v[i + apart[axis]];
      if (std::isfinite(a) && std::isfinite(b))
        s.largest_difference[axis] = std::max(s.largest_difference[axis], std::abs(b - a));
    }
  });
}

void add_plateaus(const Grid& grid, const std::vector<float>& v, VolumeStatistics& s) {
  const std::size_t row = std::size_t(grid.dims.x), slice = row * std::size_t(grid.dims.y);
  std::map<float, double> cells;
  for_each_point(grid.dims, [&](glm::ivec3 place, std::size_t i) {
    if (glm::any(glm::equal(place + 1, grid.dims))) return;
    bool is_one = true;
    for (std::size_t c = 0; c < 8; ++c)
      is_one = is_one && v[i + (c & 1) + row * (c >> 1 & 1) + slice * (c >> 2)] == v[i];
    if (is_one) ++cells[v[i]];
  });
  const glm::dvec3 all = grid.dims - 1;
  for (const auto& [value, count] : cells)
    if (count >= 1e-3 * all.x * all.y * all.z) s.plateaus.push_back(value);
}

VolumeStatistics plain_statistics(const Grid& grid, const std::vector<float>& v, int bins) {
  VolumeStatistics s;
  double sum = 0, squares = 0, count = 0;
  glm::ivec3 low = grid.dims, high(-1);
  ValueRange range{INFINITY, -INFINITY};
  for_each_point(grid.dims, [&](glm::ivec3 place, std::size_t i) {
    s.nan_count += std::isnan(v[i]);
    s.inf_count += std::isinf(v[i]);
    if (std::isfinite(v[i])) {
      sum += double(v[i]);
      ++count;
      range = joined(range, {double(v[i]), double(v[i])});
    } else {
      low = glm::min(low, place);
      high = glm::max(high, place);
    }
  });
  if (high.x >= 0) {
    s.empty_min = glm::max(low - 1, glm::ivec3(0));
    s.empty_max = glm::min(high + 1, grid.dims - 1);
  }
  if (count > 0) {
    s.range = range;
    s.mean = sum / count;
  }
  s.histogram.assign(std::size_t(bins), 0);
  for (const double value : v) {
    if (!std::isfinite(value)) continue;
    squares += (value - s.mean) * (value - s.mean);
    const double width = s.range.width(), scale = width > 0 ? bins / width : 0;
    ++s.histogram[std::min(std::size_t((value - s.range.min) * scale), std::size_t(bins) - 1)];
  }
  if (count > 0) s.variance = squares / count;
  add_differences(grid, v, s);
  add_plateaus(grid, v, s);
  return s;
}

void expect_same(const VolumeStatistics& s, const VolumeStatistics& expected, double rounding) {
  const double largest = std::max(std::abs(expected.range.min), std::abs(expected.range.max));
  EXPECT_EQ(s.range, expected.range);
  EXPECT_NEAR(s.mean, expected.mean, rounding * largest);
  EXPECT_NEAR(s.variance, expected.variance, rounding * largest * largest);
  EXPECT_EQ(s.nan_count, expected.nan_count);
  EXPECT_EQ(s.inf_count, expected.inf_count);
  EXPECT_EQ(s.histogram, expected.histogram);
  EXPECT_EQ(s.largest_difference, expected.largest_difference);
  EXPECT_EQ(s.empty_min, expected.empty_min);
  EXPECT_EQ(s.empty_max, expected.empty_max);
  EXPECT_EQ(s.plateaus, expected.plateaus);
}

Grid random_grid(Random& random) {
  Grid grid;
  grid.dims = {int(random.uniform(2, 70)), int(random.uniform(2, 12)), int(random.uniform(2, 12))};
  return grid;
}

/// Labels in blocks, or noise; of floats some have no value.
template <class T>
std::vector<T> random_values(Random& random, const Grid& grid) {
  const int kind = int(random.uniform(0, 3)), side = int(random.uniform(2, 9));
  const double low = std::is_integral_v<T> ? double(std::numeric_limits<T>::min()) : -1e3,
               high = std::is_integral_v<T> ? double(std::numeric_limits<T>::max()) + 1 : 1e3;
  const double extreme = std::pow(10, random.uniform(-30, 35));
  std::vector<T> values;
  for_each_point(grid.dims, [&](glm::ivec3 place, std::size_t) {
    const glm::ivec3 block = place / side;
    double value = kind == 0 ? (block.x + block.y + block.z) % 3 : std::floor(random.uniform(low, high));
    if constexpr (std::is_same_v<T, float>) {
      const double chance = random.uniform(0, 1);
      if (kind == 2) value *= extreme;
      if (kind == 0 && chance < 0.5 && value == 0) value = -0.0;
      if (kind > 0 && chance < 0.01) value = chance < 0.003 ? NAN : chance < 0.006 ? INFINITY : -0.0;
    }
    values.push_back(T(value));
  });
  return values;
}

template <class T>
class StatisticsPass : public ::testing::Test {};
using StoredTypes = ::testing::Types<std::uint8_t, std::int8_t, std::uint16_t, std::int16_t, float>;
TYPED_TEST_SUITE(StatisticsPass, StoredTypes);

TYPED_TEST(StatisticsPass, IsThePlainForms) {
  Random random(11);
  const LinearMap maps[] = {{}, {1, -1024}, {-3, 7}, {0.37, -0.1}, {1e-9, 1e6}, {0, 5}, {2e34, 0}};
  int with_plateaus = 0, with_holes = 0;
  for (int trial = 0; trial < 140; ++trial) {
    const Grid grid = random_grid(random);
    const LinearMap map = std::is_same_v<TypeParam, float> ? LinearMap() : maps[trial % 7];
    const Voxels values(Voxels::Stored(random_values<TypeParam>(random, grid)), map);
    const VolumeStatistics expected = plain_statistics(grid, values.to_floats(), 37);
    SCOPED_TRACE(::testing::Message() << trial << " slope " << map.slope);
    expect_same(compute_statistics(grid, values, 37), expected, 1e-12);
    with_plateaus += !expected.plateaus.empty();
    with_holes += expected.inf_count > 0;
  }
  EXPECT_GT(with_plateaus, 20);
  if (sizeof(TypeParam) > 1) {
    EXPECT_GT(with_holes, 5);
  }
}

TYPED_TEST(StatisticsPass, DoesNotDependOnTheThreads) {
  Random random(12);
  const Grid grid{{150, 120, 24}, glm::dvec3(1), glm::dvec3(0)};
  const tbb::global_control three(tbb::global_control::max_allowed_parallelism, 3);
  for (int trial = 0; trial < 8; ++trial) {  // of each kind some
    const Voxels values(Voxels::Stored(random_values<TypeParam>(random, grid)), {});
    VolumeStatistics of_one, of_some;
    tbb::task_arena(1).execute([&] { of_one = compute_statistics(grid, values); });
    tbb::task_arena(3).execute([&] { of_some = compute_statistics(grid, values); });
    expect_same(of_some, of_one, 0);
  }
}

TEST(StatisticsOfALargeVolume, TellHowFarTheyAre) {
  const Grid grid{{512, 512, 300}, glm::dvec3(1), glm::dvec3(0)};
  const Voxels values(Voxels::Stored(std::vector<std::uint8_t>(grid.point_count())), {});
  std::vector<double> told;
  compute_statistics(grid, values, 16, [&](double share) { told.push_back(share); });
  EXPECT_GT(told.size(), 1u);
  EXPECT_TRUE(std::ranges::is_sorted(told));
  EXPECT_GT(told.front(), 0);
  EXPECT_EQ(told.back(), 1);
}

}  // namespace
}  // namespace crest::test
