#include "render/volume/empty_cells.h"

#include <algorithm>
#include <cmath>

namespace crest {
namespace {

/// Calls visit(i, j, k) for each voxel without a value.
template <class Visit>
void for_each_hole(const Volume& volume, Visit&& visit) {
  const auto dims = volume.grid.dims;
  std::size_t index = 0;
  for (int k = 0; k < dims.z; ++k)
    for (int j = 0; j < dims.y; ++j)
      for (int i = 0; i < dims.x; ++i, ++index)
        if (!std::isfinite(volume.values[index])) visit(i, j, k);
}

float mean_of_neighbours(const Volume& volume, int i, int j, int k) {
  const auto dims = volume.grid.dims;
  double sum = 0;
  int count = 0;
  for (int z = std::max(k - 1, 0); z <= std::min(k + 1, dims.z - 1); ++z)
    for (int y = std::max(j - 1, 0); y <= std::min(j + 1, dims.y - 1); ++y)
      for (int x = std::max(i - 1, 0); x <= std::min(i + 1, dims.x - 1); ++x)
        if (const float value = volume.at(x, y, z); std::isfinite(value)) {
          sum += double(value);
          ++count;
        }
  return count > 0 ? float(sum / count) : float(volume.statistics.range.min);
}

}  // namespace

std::vector<std::uint8_t> find_empty_cells(const Volume& volume, int radius) {
  const glm::ivec3 cells = volume.grid.dims - 1;
  std::vector<std::uint8_t> empty(std::size_t(cells.x) * std::size_t(cells.y) * std::size_t(cells.z), 0);
  for_each_hole(volume, [&](int i, int j, int k) {
    const int below = radius, above = radius - 1;
    for (int z = std::max(k - below, 0); z <= std::min(k + above, cells.z - 1); ++z)
      for (int y = std::max(j - below, 0); y <= std::min(j + above, cells.y - 1); ++y)
        for (int x = std::max(i - below, 0); x <= std::min(i + above, cells.x - 1); ++x)
          empty[std::size_t(x) +
                std::size_t(cells.x) * (std::size_t(y) + std::size_t(cells.y) * std::size_t(z))] = 1;
  });
  return empty;
}

void write_finite(const Volume& volume, std::size_t first, std::span<float> out) {
  std::vector<float> room;
  std::ranges::copy(volume.values.part(first, out.size(), room), out.begin());
  if (!volume.has_empty_cells()) return;
  const std::size_t row = std::size_t(volume.grid.dims.x), rows = std::size_t(volume.grid.dims.y);
  for (std::size_t i = 0; i < out.size(); ++i) {
    if (std::isfinite(out[i])) continue;
    const std::size_t at = first + i;
    out[i] = mean_of_neighbours(volume, int(at % row), int(at / row % rows), int(at / row / rows));
  }
}

}  // namespace crest
