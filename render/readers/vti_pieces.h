#pragma once

#include <array>
#include <functional>
#include <glm/ext/vector_uint3_sized.hpp>
#include <memory>
#include <string>
#include <vector>

#include "render/readers/voxel_stream.h"

namespace crest {

/// The extent of a piece, in points counted from anywhere: least and greatest on x, y and z.
using VtiExtent = std::array<double, 6>;

/// The least extent that holds both.
VtiExtent joined(const VtiExtent& a, const VtiExtent& b);
/// How many points, or cells.
glm::u64vec3 dims_of(const VtiExtent& extent, bool of_cells);
/// Where a piece begins in a grid that holds it.
glm::u64vec3 place_of(const VtiExtent& piece, const VtiExtent& grid);

/// A grid, x fastest, which holds that of a piece.
struct VtiSource {
  std::unique_ptr<ByteStream> values;
  glm::u64vec3 dims{0}, first{0};  ///< of the whole of it; where the piece begins in it
};

/// Points of a grid, and what has them.
struct VtiPart {
  glm::u64vec3 first{0}, dims{0};   ///< where it begins in the grid, and of how many points it is
  std::function<VtiSource()> open;  ///< called when the first of its points is asked for
  VtiSource source = {};            ///< while some are
};

/// The values of a grid, x fastest, from pieces of it, each of which may hold points of another one, too. A
/// piece is open only while its points are asked for.
class VtiGrid : public ByteStream {
 public:
  /// `point_bytes`: of all components of a point. `name` begins the errors.
  VtiGrid(std::string name, glm::u64vec3 dims, std::size_t point_bytes, std::vector<VtiPart> parts);
  /// Throws Error where no piece has a point.
  void read(std::uint64_t first, std::span<std::byte> out) override;
  bool finish() override;

 private:
  static void close(VtiPart& part);
  void take(VtiPart& part, std::uint64_t first, std::span<std::byte> out);

  std::string name_;
  glm::u64vec3 dims_;
  std::uint64_t point_bytes_;
  std::vector<VtiPart> parts_;
  std::vector<std::uint8_t> is_there_;  ///< of the bytes that are asked for
};

}  // namespace crest
