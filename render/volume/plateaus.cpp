#include "render/volume/plateaus.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <map>
#include <unordered_map>
#include <utility>

namespace crest {
namespace {

using Counts = std::unordered_map<float, std::size_t>;

/// Of the cells between two slices, a run of one value at a time. NaN equals nothing.
void count_slice(const Grid& grid, const float* slice, Counts& counts) {
  float last = 0;
  std::size_t run = 0;
  const std::size_t row = std::size_t(grid.dims.x), next = row * std::size_t(grid.dims.y);
  for (int y = 0; y + 1 < grid.dims.y; ++y)
    for (int x = 0; x + 1 < grid.dims.x; ++x) {
      const float* at = slice + std::size_t(x) + row * std::size_t(y);
      const float value = *at;
      if (at[1] == value && at[row] == value && at[row + 1] == value && at[next] == value &&
          at[next + 1] == value && at[next + row] == value && at[next + row + 1] == value) {
        if (value != last && run > 0) counts[last] += std::exchange(run, 0);
        last = value;
        ++run;
      }
    }
  if (run > 0) counts[last] += run;
}

}  // namespace

std::vector<float> find_plateaus(const Grid& grid, const Voxels& values) {
  const std::size_t slice = std::size_t(grid.dims.x) * std::size_t(grid.dims.y);
  tbb::enumerable_thread_specific<Counts> parts;
  tbb::parallel_for(0, grid.dims.z - 1, [&](int z) {
    std::vector<float> room;
    count_slice(grid, values.part(slice * std::size_t(z), 2 * slice, room).data(), parts.local());
  });
  std::map<float, std::size_t> counts;
  for (const Counts& part : parts)
    for (const auto& [value, count] : part) counts[value] += count;
  const glm::dvec3 cells = grid.dims - 1;
  std::vector<float> plateaus;
  for (const auto& [value, count] : counts)
    if (double(count) >= 1e-3 * cells.x * cells.y * cells.z) plateaus.push_back(value);
  return plateaus;
}

}  // namespace crest
