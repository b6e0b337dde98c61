#include "render/measure/tiles.h"

#include <algorithm>

#include "render/measure/timing.h"

namespace crest {
namespace {

/// Of a picture of which nothing is known, the first tile is such a part.
constexpr int first_part = 64;

}  // namespace

int next_tile_rows(int rows, double ms, double tile_ms) {
  const double wanted = rows * tile_ms / std::max(ms, 1e-6);
  return std::max(int(std::min(wanted, 2.0 * rows)), 1);
}

double draw_in_tiles(glm::ivec2 size, double& ms_per_row, const std::function<void(Tile)>& draw,
                     double tile_ms) {
  int rows = std::max(size.y / first_part, 1);
  if (ms_per_row > 0) rows = std::max(int(std::min(tile_ms / ms_per_row, double(size.y))), 1);
  double total = 0;
  for (int row = 0; row < size.y;) {
    const int end = std::min(row + rows, size.y);
    const double ms = finished_ms([&] { draw({{0, row}, {size.x, end}}); });
    rows = next_tile_rows(end - row, ms, tile_ms);
    row = end;
    total += ms;
  }
  ms_per_row = total / size.y;
  return total;
}

}  // namespace crest
