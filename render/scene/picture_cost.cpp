#include "render/scene/picture_cost.h"

#include <algorithm>
#include <cmath>

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
    if (!pixel.hit || std::isnan(pixel.error_bound)) continue;
    total.bounded_pixels += 1;
    total.greatest_error_bound = std::max(total.greatest_error_bound, double(pixel.error_bound));
    total.pixels_within_bound += double(pixel.error_bound) <= 1.0 / 255;
  }
  return total;
}

}  // namespace crest
