#include "render/volume/differences.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <glm/geometric.hpp>

namespace crest {
namespace {

/// Between `count` values and those `offset` after them; pairs without two finite values do not count: their
/// difference is NaN or infinite, which no difference of finite floats is in double.
double largest_in_row(const float* values, std::size_t count, std::size_t offset) {
  double largest = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const double difference = std::abs(double(values[i + offset]) - double(values[i]));
    if (difference > largest && difference <= 2.0 * double(FLT_MAX)) largest = difference;
  }
  return largest;
}

/// Within a slice, and to the next one.
glm::dvec3 largest_in_slice(const glm::ivec3 dims, const Voxels& values, int k, std::vector<float>& room) {
  const std::size_t x = std::size_t(dims.x), slice = x * std::size_t(dims.y);
  const float* first = values.part(std::size_t(k) * slice, k + 1 < dims.z ? 2 * slice : slice, room).data();
  glm::dvec3 largest(0);
  for (int j = 0; j < dims.y; ++j) {
    const float* row = first + std::size_t(j) * x;
    largest.x = std::max(largest.x, largest_in_row(row, x - 1, 1));
    if (j + 1 < dims.y) largest.y = std::max(largest.y, largest_in_row(row, x, x));
    if (k + 1 < dims.z) largest.z = std::max(largest.z, largest_in_row(row, x, slice));
  }
  return largest;
}

}  // namespace

glm::dvec3 largest_differences(const Grid& grid, const Voxels& values) {
  return tbb::parallel_reduce(
      tbb::blocked_range<int>(0, grid.dims.z), glm::dvec3(0),
      [&](const auto& slices, glm::dvec3 largest) {
        std::vector<float> room;
        for (int k = slices.begin(); k != slices.end(); ++k)
          largest = glm::max(largest, largest_in_slice(grid.dims, values, k, room));
        return largest;
      },
      [](glm::dvec3 a, glm::dvec3 b) { return glm::max(a, b); });
}

PointBox empty_part(const Grid& grid, const Voxels& values) {
  glm::ivec3 low = grid.dims, high(-1);
  std::size_t index = 0;
  for (int k = 0; k < grid.dims.z; ++k)
    for (int j = 0; j < grid.dims.y; ++j)
      for (int i = 0; i < grid.dims.x; ++i, ++index)
        if (!std::isfinite(values[index])) {
          low = glm::min(low, glm::ivec3(i, j, k));
          high = glm::max(high, glm::ivec3(i, j, k));
        }
  // The cells around a point reach to its neighbours
  return {glm::max(low - 1, glm::ivec3(0)), glm::min(high + 1, grid.dims - 1)};
}

double largest_gradient(const Grid& grid, const VolumeStatistics& statistics) {
  return glm::length(statistics.largest_difference / grid.spacing);
}

}  // namespace crest
