#pragma once

#include <array>
#include <cstddef>
#include <glm/ext/vector_uint3_sized.hpp>
#include <span>
#include <string>
#include <vector>

namespace crest {

/// The extent of a piece, in points counted from anywhere: least and greatest on x, y and z.
using VtiExtent = std::array<double, 6>;

/// The least extent that holds all of them. There is one at least.
VtiExtent joined(const std::vector<VtiExtent>& pieces);

/// A whole grid that pieces are put into, each of which may hold points of another one, too.
class VtiGrid {
 public:
  /// `point_bytes`: of all components of a point.
  VtiGrid(glm::u64vec3 dims, std::size_t point_bytes);
  /// `first`: the piece's first point in the grid, of which it holds `dims`, x fastest.
  void put(std::span<const std::byte> piece, glm::u64vec3 first, glm::u64vec3 dims);
  /// Throws Error, which begins with `name`, unless each point is there.
  std::vector<std::byte> take(const std::string& name);

 private:
  glm::u64vec3 dims_;
  std::size_t point_bytes_;
  std::vector<std::byte> bytes_;
  std::vector<bool> is_there_;
};

}  // namespace crest
