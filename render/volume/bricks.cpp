#include "render/volume/bricks.h"

#include <algorithm>
#include <glm/common.hpp>

#include "render/volume/macrocells.h"

namespace crest {
namespace {

/// Marks of macrocells on one axis become those of the bricks that they reach into; `dims` follows.
std::vector<std::uint8_t> spread(const std::vector<std::uint8_t>& marks, glm::ivec3& dims, int axis,
                                 const Grid& grid, int side, int reach) {
  const int bricks = brick_dims(grid)[axis], last_cell = grid.dims[axis] - 2;
  std::size_t stride = 1, lines = 1;
  for (int i = 0; i < 3; ++i) (i < axis ? stride : lines) *= std::size_t(i == axis ? 1 : dims[i]);
  std::vector<std::uint8_t> spread_marks(stride * std::size_t(bricks) * lines);
  for (std::size_t line = 0; line < stride * lines; ++line) {
    const std::size_t outer = line / stride, inner = line % stride;
    const auto from = marks.begin() + std::ptrdiff_t(outer * stride * std::size_t(dims[axis]) + inner);
    const auto to = spread_marks.begin() + std::ptrdiff_t(outer * stride * std::size_t(bricks) + inner);
    int next = 0;  // what lies before it is marked, or is not reached by macrocells from here on
    for (int i = 0; i < dims[axis]; ++i) {
      if (!from[std::ptrdiff_t(stride) * i]) continue;
      const int last = std::clamp(side * (i + 1) + reach, 0, last_cell) / brick_cells;
      next = std::max(next, std::clamp(side * i - reach, 0, last_cell) / brick_cells);
      for (; next <= last; ++next) to[std::ptrdiff_t(stride) * next] = 1;
    }
  }
  dims[axis] = bricks;
  return spread_marks;
}

}  // namespace

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

// A box is the product of its axes' ranges, so that each axis is gone through by itself.
BrickSet bricks_around(const std::vector<std::uint8_t>& macrocells, const Grid& grid, int side, int reach) {
  glm::ivec3 dims = macrocell_dims(grid, side);
  BrickSet marks = macrocells;
  for (int axis = 0; axis < 3; ++axis) marks = spread(marks, dims, axis, grid, side, reach);
  return marks;
}

}  // namespace crest
