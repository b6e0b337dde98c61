#pragma once

#include <glm/ext/vector_uint3_sized.hpp>
#include <string>
#include <string_view>

#include "render/volume/query.h"

namespace crest {

/// Which of a grid's points become a volume: those of a box, and of them every stride-th on each axis, from
/// the box's first point on. Points are left out, not averaged.
struct GridPart {
  glm::u64vec3 full{0};           ///< points of the whole grid
  glm::u64vec3 first{0}, end{0};  ///< of the box, counted in points of the whole: [first, end)
  glm::u64vec3 stride{1};         ///< at least 1
  bool operator==(const GridPart&) const = default;

  bool is_whole() const { return is_box_whole() && stride == glm::u64vec3(1); }
  bool is_box_whole() const { return first == glm::u64vec3(0) && end == full; }
  std::uint64_t point_count() const { return dims().x * dims().y * dims().z; }
  glm::u64vec3 dims() const { return (end - first + stride - glm::u64vec3(1)) / stride; }
};

/// Of the same box no more than every stride-th point, as far as two stay on each axis.
GridPart at_stride(GridPart part, std::uint64_t stride);

/// All points.
GridPart whole_grid(glm::u64vec3 dims);

/// What ?crop=x0:x1,y0:y1,z0:z1 and ?stride=n or ?stride=x,y,z say of a grid of `dims` points. As in NumPy
/// the first point is taken and the last one is not, either may be left out, and the box is cut first. Throws
/// Error, which begins with `name`, for a box that is not in the grid, or where fewer than 2 points are left
/// on an axis that had them.
GridPart part_from_query(std::string_view name, const Query& query, glm::u64vec3 dims);
/// The keys that it takes, each after a comma.
inline constexpr std::string_view part_keys = ",crop,stride";
/// `query` for this part.
Query with_part(Query query, const GridPart& part);

/// "every 2nd point of 512x512x400, of the box 0:256,0:512,10:400"; empty for a whole grid.
std::string part_text(const GridPart& part);
/// "every 2nd point", "box 0:256,0:512,10:400", or both; empty for a whole grid.
std::string short_part_text(const GridPart& part);

}  // namespace crest
