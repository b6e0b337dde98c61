#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <limits>
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
  /// Each channel of the pixel is so far from the exact answer, at most: the exact march knows; else NaN.
  float error_bound = std::numeric_limits<float>::quiet_NaN();
};

/// What a picture cost, over all its pixels.
struct RenderCounts {
  double pixels = 0, hit_pixels = 0;  ///< all, and those whose ray meets the box
  double samples = 0,
         dvr_samples = 0;  ///< field evaluations (gradient taps apart), and those that DVR classified
  double crossings = 0;
  double crossings_left_out = 0;  ///< in steps with more than max_peaks, in the paper's form
  /// Of pixels whose ray meets the box and that know their error bound: how many, the greatest, and for how
  /// many it is within 1/255.
  double bounded_pixels = 0, greatest_error_bound = 0, pixels_within_bound = 0;
};
RenderCounts sum_of(const std::vector<PixelCounts>& pixels);

}  // namespace crest
