#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <vector>

namespace crest {

/// Pixels of a target to draw: rows and columns from `begin` up to but not including `end`.
struct Tile {
  glm::ivec2 begin, end;
};

/// What one pixel cost.
struct PixelCounts {
  std::uint32_t samples = 0, dvr_samples = 0;  ///< as in RenderCounts
  std::uint32_t crossings = 0, crossings_left_out = 0;
  bool hit = false;  ///< its ray meets the box
};

/// What a picture cost, over all its pixels.
struct RenderCounts {
  double pixels = 0, hit_pixels = 0;  ///< all, and those whose ray meets the box
  double samples = 0,
         dvr_samples = 0;  ///< field evaluations (gradient taps apart), and those that DVR classified
  double crossings = 0;
  double crossings_left_out = 0;  ///< in steps with more than max_peaks, in the paper's form
};
RenderCounts sum_of(const std::vector<PixelCounts>& pixels);

}  // namespace crest
