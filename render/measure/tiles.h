#pragma once

#include <functional>
#include <glm/vec2.hpp>

#include "render/scene/picture_cost.h"

namespace crest {

/// A tile keeps the graphics device busy for about so long: drivers end a program whose draw takes seconds.
inline constexpr double default_tile_ms = 100;

/// How many rows the next tile has, after `rows` took `ms`: at least one, and at most twice as many, since
/// the rows that come may cost more.
int next_tile_rows(int rows, double ms, double tile_ms);

/// Calls draw(tile) for tiles of whole rows from the top to the bottom, and waits for each of them; returns
/// the milliseconds that all took. `ms_per_row` is what a row took in the last picture of the kind, or 0
/// where there is none; it becomes this one's. A GL context must be current.
double draw_in_tiles(glm::ivec2 size, double& ms_per_row, const std::function<void(Tile)>& draw,
                     double tile_ms = default_tile_ms);

}  // namespace crest
