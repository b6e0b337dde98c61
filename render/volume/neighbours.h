#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <unordered_map>

#include "render/volume/volume.h"

namespace crest {

/// What neighbours in a grid are to each other: found slice by slice, and joined.
struct Neighbours {
  /// VolumeStatistics::largest_difference.
  glm::dvec3 largest_difference{0};
  /// Between these lie the points that are NaN or infinite; high < low when there is none.
  glm::ivec3 low, high{-1};
  /// How many cells have a value at all eight corners.
  std::unordered_map<float, std::size_t> uniform_cells;

  explicit Neighbours(const Grid& grid) : low(grid.dims) {}
  void join(const Neighbours& other);
};

/// All of a grid's slices [begin, end) to the next ones, on this thread.
void add_neighbours(const Grid& grid, const Voxels& values, int begin, int end, Neighbours& found);

/// Values that at least a thousandth of the cells have at all corners, ascending.
std::vector<float> plateaus_of(const Grid& grid, const Neighbours& found);

}  // namespace crest
