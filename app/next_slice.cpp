#include "app/next_slice.h"

#include <algorithm>

namespace crest {
namespace {

constexpr int least_rows = 4, least_columns = 16;  // less costs more than its pixels

}  // namespace

Tile next_slice(glm::ivec2 size, glm::ivec2 begin, double pixels) {
  const auto count = [&](double along) { return int(std::clamp(pixels / along, 0.0, 1e6)); };
  int rows = std::min(std::max(count(size.x), least_rows), size.y - begin.y);
  int columns = size.x - begin.x;
  if (begin.x > 0 || count(size.x) < least_rows) {
    rows = std::min(least_rows, size.y - begin.y);
    columns = std::min(columns, std::max(count(least_rows), least_columns));
  }
  return {begin, {begin.x + columns, begin.y + rows}};
}

glm::ivec2 after(const Tile& slice, glm::ivec2 size) {
  if (slice.end.x < size.x) return {slice.end.x, slice.begin.y};
  return {0, slice.end.y};
}

}  // namespace crest
