#include "render/raycaster/pending_counts.h"

#include <algorithm>
#include <bit>

namespace crest {

void add_counts(std::vector<PixelCounts>& sums, const std::vector<glm::uvec4>& counts, CountsOf what,
                bool is_first) {
  sums.resize(counts.size());
  for (std::size_t i = 0; i < counts.size(); ++i) {
    PixelCounts& sum = sums[i];
    sum.samples += counts[i].x;
    sum.dvr_samples += counts[i].y;
    sum.hit = counts[i].w >> 31;
    if (what == CountsOf::layers) continue;
    sum.crossings += counts[i].z;
    const std::uint32_t rest = counts[i].w & 0x7fffffffu;
    if (what == CountsOf::exact_march)
      sum.error_bound = std::min((is_first ? 0.0F : sum.error_bound) + std::bit_cast<float>(rest), 1.0F);
    else
      sum.crossings_left_out += rest;
  }
}

bool PendingCounts::is_over() const {
  return std::ranges::all_of(passes, [](const gl::PendingRead& pass) { return pass.is_over(); });
}

std::vector<PixelCounts> PendingCounts::take() const {
  std::vector<PixelCounts> sums;
  for (const gl::PendingRead& pass : passes) add_counts(sums, pass.counts(), what, &pass == &passes.front());
  return sums;
}

}  // namespace crest
