#include "render/volume/bricks.h"

#include <algorithm>
#include <glm/common.hpp>

namespace crest {

std::size_t brick_count(const Grid& grid) {
  const glm::ivec3 dims = brick_dims(grid);
  return std::size_t(dims.x) * std::size_t(dims.y) * std::size_t(dims.z);
}

std::size_t size_of(const BrickSet& set) { return std::size_t(std::ranges::count(set, 1)); }

void add_bricks(BrickSet& set, const Grid& grid, glm::ivec3 first, glm::ivec3 last) {
  const glm::ivec3 dims = brick_dims(grid), cells = grid.dims - 2;
  const glm::ivec3 from = glm::clamp(first, glm::ivec3(0), cells) / brick_cells,
                   to = glm::clamp(last, glm::ivec3(0), cells) / brick_cells;
  for (int z = from.z; z <= to.z; ++z)
    for (int y = from.y; y <= to.y; ++y) {
      const auto row = set.begin() + std::ptrdiff_t(dims.x) * (y + std::ptrdiff_t(dims.y) * z);
      std::fill(row + from.x, row + to.x + 1, std::uint8_t(1));
    }
}

}  // namespace crest
