#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

namespace crest {

/// A box of cells, from its first to its last one.
struct CellBox {
  glm::ivec3 first, last;
};

/// Boxes that hold all cells (x fastest) that are not 0: around those in each block of `block_side` along
/// each side.
inline constexpr int block_side = 4;
std::vector<CellBox> occupied_boxes(const std::vector<std::uint8_t>& cells, glm::ivec3 dims);

/// Of each cell how far the nearest one of the other kind - 0, or not 0 - is, in cells on the axis on which
/// that is most (Chebyshev's distance), at most `greatest_distance`; negative where the cell is 0. All that
/// is nearer is of its kind.
inline constexpr int greatest_distance = 32;
std::vector<std::int8_t> distances(const std::vector<std::uint8_t>& cells, glm::ivec3 dims);

}  // namespace crest
