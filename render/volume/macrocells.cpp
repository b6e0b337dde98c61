#include "render/volume/macrocells.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <limits>
#include <numeric>
#include <type_traits>

#include "render/volume/exact_map.h"

namespace crest {
namespace {

/// What the points of a box hold, both ends included.
struct Extent {
  float min = std::numeric_limits<float>::infinity(), max = -std::numeric_limits<float>::infinity();
  double sum = 0, squares = 0;  ///< of value - some origin
  int count = 0;

  double deviation() const {
    return count == 0 ? 0 : std::sqrt(std::max(squares / count - (sum / count) * (sum / count), 0.0));
  }
};

/// Calls `visit` with the index of each row's first point. `to`: included.
template <class Visit>
void for_each_row(const Volume& volume, glm::ivec3 from, glm::ivec3 to, const Visit& visit) {
  for (int k = from.z; k <= to.z; ++k)
    for (int j = from.y; j <= to.y; ++j) visit(volume.index(from.x, j, k));
}

/// Of any values.
Extent extent_of_floats(const Volume& volume, glm::ivec3 from, glm::ivec3 to) {
  const double origin = volume.statistics.mean;
  const std::size_t length = std::size_t(to.x - from.x + 1);
  Extent extent;
  std::vector<float> room;
  for_each_row(volume, from, to, [&](std::size_t first) {
    for (const float value : volume.values.part(first, length, room)) {
      if (!std::isfinite(value)) continue;
      extent.min = std::min(extent.min, value);
      extent.max = std::max(extent.max, value);
      const double beyond = double(value) - origin;
      extent.sum += beyond;
      extent.squares += beyond * beyond;
      ++extent.count;
    }
  });
  return extent;
}

/// Of stored integers that stand for their values (is_exact): summed without rounding, from the first one.
template <class T>
Extent extent_of_integers(const Volume& volume, const std::vector<T>& stored, glm::ivec3 from,
                          glm::ivec3 to) {
  const std::size_t length = std::size_t(to.x - from.x + 1);
  const int origin = stored[volume.index(from.x, from.y, from.z)];
  T least = stored[volume.index(from.x, from.y, from.z)], greatest = least;
  std::int64_t sum = 0;
  std::uint64_t squares = 0;
  for_each_row(volume, from, to, [&](std::size_t first) {
    for (std::size_t i = first; i < first + length; ++i) {
      const T value = stored[i];
      least = std::min(least, value);
      greatest = std::max(greatest, value);
      const int beyond = value - origin;
      sum += beyond;
      squares += unsigned(beyond) * unsigned(beyond);  // under 2^32, of either sign
    }
  });
  const LinearMap map = volume.values.map();
  const float a = mapped_to_float(least, map), b = mapped_to_float(greatest, map);
  const glm::ivec3 points = to - from + 1;
  return {std::min(a, b), std::max(a, b), map.slope * double(sum), map.slope * map.slope * double(squares),
          points.x * points.y * points.z};
}

Extent extent_of(const Volume& volume, glm::ivec3 from, glm::ivec3 to) {
  return std::visit(
      [&](const auto& stored) {
        using T = typename std::decay_t<decltype(stored)>::value_type;
        if constexpr (std::is_integral_v<T>)
          if (is_exact(volume.values.map())) return extent_of_integers(volume, stored, from, to);
        return extent_of_floats(volume, from, to);
      },
      volume.values.stored());
}

/// Widened by what interpolation in float may go beyond its points.
void store(Macrocells& macrocells, std::size_t index, ValueRange range, double field_width) {
  const double rounding = 0x1p-20 * field_width;
  macrocells.min[index] = float(range.min - rounding);
  macrocells.max[index] = float(range.max + rounding);
}

}  // namespace

int macrocell_side(const Grid& grid, const VolumeStatistics& statistics) {
  const auto& bins = statistics.histogram;
  const auto fullest = bins.empty() ? 0 : *std::ranges::max_element(bins);
  const bool is_mostly_background = fullest > std::accumulate(bins.begin(), bins.end(), std::uint64_t(0)) / 2;
  const int least = is_mostly_background ? 2 : 4, most = is_mostly_background ? 96 : 64;
  const int longest = std::max({grid.dims.x, grid.dims.y, grid.dims.z}) - 1;
  return std::max(least, (longest + most - 1) / most);
}

Macrocells build_macrocells(const Volume& volume, const FieldFilter& filter, int side) {
  const glm::ivec3 last = volume.grid.dims - 1;
  const int around = filter_bounds(filter).radius - 1;
  Macrocells result;
  result.cells = side;
  result.dims = macrocell_dims(volume.grid, side);
  const std::size_t row = std::size_t(result.dims.x), slice = row * std::size_t(result.dims.y);
  const std::size_t count = slice * std::size_t(result.dims.z);
  result.min.assign(count, std::numeric_limits<float>::infinity());
  result.max.assign(count, -std::numeric_limits<float>::infinity());
  result.deviation.assign(count, 0);
  tbb::parallel_for(std::size_t(0), count, [&](std::size_t index) {
    const glm::ivec3 cell(index % row, index % slice / row, index / slice);
    const glm::ivec3 from = cell * side, to = glm::min(from + side, last);
    const Extent own = extent_of(volume, from, to);
    const Extent all =
        around == 0 ? own
                    : extent_of(volume, glm::max(from - around, glm::ivec3(0)), glm::min(to + around, last));
    result.deviation[index] = float(own.deviation());
    if (all.count > 0)
      store(result, index, field_range(filter, {double(all.min), double(all.max)}),
            volume.statistics.range.width());
  });
  return result;
}

}  // namespace crest
