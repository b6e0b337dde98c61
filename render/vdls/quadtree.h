#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

namespace crest {

/// A square of the screen, cut at the picture's edges by whoever draws it.
struct ScreenNode {
  glm::ivec2 begin;  ///< in pixels
  int side = 0;      ///< in pixels
  int layers = 0;    ///< the greatest sample count of its rays
};

/// The active nodes of the dynamic screen quadtree (VDLS, section 4.2): its leaves are `leaves` x `leaves`
/// squares (a power of two) of `leaf_side` pixels, `counts` their rays' greatest sample counts, row by row.
/// Four brothers whose counts differ by no more than `threshold` become one node. Nodes without samples are
/// left out.
std::vector<ScreenNode> screen_quadtree(std::span<const std::uint32_t> counts, int leaves, int leaf_side,
                                        int threshold);

}  // namespace crest
