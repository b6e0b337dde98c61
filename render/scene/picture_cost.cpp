#include "render/scene/picture_cost.h"

namespace crest {

RenderCounts sum_of(const std::vector<PixelCounts>& pixels) {
  RenderCounts total;
  for (const PixelCounts& pixel : pixels) {
    total.pixels += 1;
    total.hit_pixels += pixel.hit;
    total.samples += pixel.samples;
    total.dvr_samples += pixel.dvr_samples;
    total.crossings += pixel.crossings;
    total.crossings_left_out += pixel.crossings_left_out;
  }
  return total;
}

}  // namespace crest
