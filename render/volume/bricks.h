#pragma once

#include <cstdint>
#include <vector>

#include "render/volume/volume.h"

namespace crest {

/// A volume's cells in cubes of so many an axis. A brick has the points at both ends of its cells, so that
/// what lies between points is found in one brick.
inline constexpr int brick_cells = 32, brick_points = brick_cells + 1;

/// Bricks on each axis; those at the far sides reach beyond the grid.
inline glm::ivec3 brick_dims(const Grid& grid) { return (grid.dims - 2 + brick_cells) / brick_cells; }

/// Some of a volume's bricks, x fastest: 1 for those that are in.
using BrickSet = std::vector<std::uint8_t>;
std::size_t brick_count(const Grid& grid);
std::size_t size_of(const BrickSet& set);

/// Adds those that hold the points of a box, both ends included, which may reach beyond the grid.
void add_bricks(BrickSet& set, const Grid& grid, glm::ivec3 first, glm::ivec3 last);

/// The same of many boxes: of the macrocells of `side` cells that are marked with other than 0, x fastest
/// (macrocell_dims), each with `reach` points beyond it on all sides. O(macrocells + bricks), whatever the
/// reach.
BrickSet bricks_around(const std::vector<std::uint8_t>& macrocells, const Grid& grid, int side, int reach);

}  // namespace crest
