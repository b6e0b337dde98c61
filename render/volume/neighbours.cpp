#include "render/volume/neighbours.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/common.hpp>
#include <limits>
#include <vector>

#include "render/volume/exact_map.h"
#include "render/volume/row_scan.h"

namespace crest {
namespace {

/// A slice's rows against each other, and against the next slice's.
template <class T>
class SliceScan {
 public:
  SliceScan(const Grid& grid, LinearMap map, Neighbours& found)
      : dims_(grid.dims), row_(std::size_t(grid.dims.x)), map_(map), found_(found), marks_(row_) {}

  /// `next`: null behind the last.
  void add(int k, const T* slice, const T* next) {
    for (int j = 0; j < dims_.y; ++j) {
      const T* const row = slice + row_ * std::size_t(j);
      const T* const above = next ? next + row_ * std::size_t(j) : nullptr;
      largest_.x = largest_difference(row, row + 1, row_ - 1, largest_.x);
      if (above) largest_.z = largest_difference(row, above, row_, largest_.z);
      if (j + 1 < dims_.y) largest_.y = largest_difference(row, row + row_, row_, largest_.y);
      if (above && j + 1 < dims_.y) add_uniform_cells(row, above);
      if constexpr (std::is_same_v<T, float>) add_holes(row, j, k);
    }
  }
  void finish() {
    found_.largest_difference =
        glm::max(found_.largest_difference, std::abs(map_.slope) * glm::dvec3(largest_));
  }

 private:
  /// A run has one value, since its cells share corners.
  void add_uniform_cells(const T* row, const T* above) {
    mark_uniform_cells(row, row + row_, above, above + row_, row_ - 1, marks_.data());
    for_each_run(marks_.data(), row_ - 1, [&](std::size_t first, std::size_t length) {
      found_.uniform_cells[mapped_to_float(row[first], map_) + 0.F] += length;  // -0 is 0
    });
  }
  void add_holes(const float* row, int j, int k) {
    constexpr std::int32_t infinity = 0x7F800000;
    // Where all are finite, and lie no further apart than floats go, so is each difference
    if (largest_difference_bits(row, row + 1, row_ - 1) < infinity) return;
    for (int i = 0; i < dims_.x; ++i) {
      if (std::isfinite(row[i])) continue;
      found_.low = glm::min(found_.low, glm::ivec3(i, j, k));
      found_.high = glm::max(found_.high, glm::ivec3(i, j, k));
    }
  }

  glm::ivec3 dims_;
  std::size_t row_;
  LinearMap map_;
  Neighbours& found_;
  glm::vec<3, DifferenceOf<T>> largest_{0};
  std::vector<std::uint8_t> marks_;
};

template <class T>
void add_stored(const Grid& grid, const std::vector<T>& values, LinearMap map, int begin, int end,
                Neighbours& found) {
  const std::size_t slice = std::size_t(grid.dims.x) * std::size_t(grid.dims.y);
  SliceScan<T> scan(grid, map, found);
  for (int k = begin; k < end; ++k) {
    const T* const first = values.data() + slice * std::size_t(k);
    scan.add(k, first, k + 1 < grid.dims.z ? first + slice : nullptr);
  }
  scan.finish();
}

/// Of values that are not what is stored: each slice is mapped once.
void add_mapped(const Grid& grid, const Voxels& values, int begin, int end, Neighbours& found) {
  const std::size_t size = std::size_t(grid.dims.x) * std::size_t(grid.dims.y);
  std::vector<float> rooms[2];
  const auto slice = [&](int k) { return values.part(size * std::size_t(k), size, rooms[k % 2]).data(); };
  SliceScan<float> scan(grid, {}, found);
  const float* first = slice(begin);
  for (int k = begin; k < end; ++k) {
    const float* const next = k + 1 < grid.dims.z ? slice(k + 1) : nullptr;
    scan.add(k, first, next);
    first = next;
  }
  scan.finish();
}

}  // namespace

void Neighbours::join(const Neighbours& other) {
  largest_difference = glm::max(largest_difference, other.largest_difference);
  low = glm::min(low, other.low);
  high = glm::max(high, other.high);
  for (const auto& [value, count] : other.uniform_cells) uniform_cells[value] += count;
}

void add_neighbours(const Grid& grid, const Voxels& values, int begin, int end, Neighbours& found) {
  const LinearMap map = values.map();
  if (!values.are_floats() && !is_exact(map)) return add_mapped(grid, values, begin, end, found);
  std::visit([&](const auto& stored) { add_stored(grid, stored, map, begin, end, found); }, values.stored());
}

std::vector<float> plateaus_of(const Grid& grid, const Neighbours& found) {
  const glm::dvec3 cells = grid.dims - 1;
  std::vector<float> plateaus;
  for (const auto& [value, count] : found.uniform_cells)
    if (double(count) >= 1e-3 * cells.x * cells.y * cells.z) plateaus.push_back(value);
  std::ranges::sort(plateaus);
  return plateaus;
}

}  // namespace crest
