#pragma once

#include <vector>

#include "render/gl/pending_read.h"
#include "render/scene/picture_cost.h"

namespace crest {

/// What the counters of a pixel are.
enum class CountsOf { samples, exact_march, layers };

/// Adds what one pass counted to the sums, of all pixels; `is_first` of the picture's passes.
void add_counts(std::vector<PixelCounts>& sums, const std::vector<glm::uvec4>& counts, CountsOf what,
                bool is_first);

/// The costs of a picture that the device may not be through with.
struct PendingCounts {
  CountsOf what = CountsOf::samples;
  std::vector<gl::PendingRead> passes;

  bool is_over() const;                   ///< does not wait
  std::vector<PixelCounts> take() const;  ///< waits
};

}  // namespace crest
