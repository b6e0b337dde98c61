#include "render/classify/cell_boxes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <glm/common.hpp>
#include <random>

namespace crest {
namespace {

glm::ivec3 place(std::size_t cell, glm::ivec3 dims) {
  const int i = int(cell);
  return {i % dims.x, i / dims.x % dims.y, i / dims.x / dims.y};
}

/// Of these dims, each cell set by a chance of one in `sparseness`.
std::vector<std::uint8_t> random_cells(glm::ivec3 dims, unsigned sparseness, std::mt19937& random) {
  std::vector<std::uint8_t> cells(std::size_t(dims.x * dims.y * dims.z));
  for (auto& cell : cells) cell = random() % sparseness == 0;
  return cells;
}

int distance_by_search(const std::vector<std::uint8_t>& cells, glm::ivec3 dims, std::size_t from) {
  int nearest = greatest_distance;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const glm::ivec3 apart = glm::abs(place(i, dims) - place(from, dims));
    if (cells[i] != cells[from]) nearest = std::min(nearest, std::max({apart.x, apart.y, apart.z}));
  }
  return cells[from] ? nearest : -nearest;
}

// Rows of less than a word, of one and of more, and distances beyond the greatest that is told.
TEST(CellBoxes, DistancesAreThoseOfASearch) {
  std::mt19937 random(3);
  for (const glm::ivec3 dims :
       {glm::ivec3(1), glm::ivec3(9, 7, 5), glm::ivec3(64, 3, 4), glm::ivec3(131, 4, 3)})
    for (const unsigned sparseness : {1u, 2u, 40u, 400u, 1000000u}) {
      const auto cells = random_cells(dims, sparseness, random);
      const auto found = distances(cells, dims);
      for (std::size_t i = 0; i < cells.size(); i += 1 + random() % 5)
        ASSERT_EQ(found[i], distance_by_search(cells, dims, i)) << dims.x << ' ' << sparseness << ' ' << i;
    }
}

TEST(CellBoxes, HoldAllOccupiedCellsTightly) {
  std::mt19937 random(4);
  const glm::ivec3 dims(13, 8, 6);
  for (const unsigned sparseness : {2u, 30u, 300u}) {
    const auto cells = random_cells(dims, sparseness, random);
    const auto boxes = occupied_boxes(cells, dims);
    const auto holds = [&](const CellBox& box, std::size_t i) {
      const glm::ivec3 p = place(i, dims);
      return glm::clamp(p, box.first, box.last) == p;
    };
    for (std::size_t i = 0; i < cells.size(); ++i)
      EXPECT_EQ(std::ranges::count_if(boxes, [&](const CellBox& box) { return cells[i] && holds(box, i); }),
                cells[i]);
    for (const CellBox& box : boxes) {
      const glm::ivec3 size = box.last - box.first;
      EXPECT_LT(std::max({size.x, size.y, size.z}), block_side);
      bool is_any = false;
      for (std::size_t i = 0; i < cells.size(); ++i) is_any |= cells[i] && holds(box, i);
      EXPECT_TRUE(is_any);
    }
  }
}

}  // namespace
}  // namespace crest
