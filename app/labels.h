#pragma once

#include <string_view>

#include "render/files/image.h"

namespace crest {

/// Draws text into an image, white on a dark strip; (x, y) is its upper left corner, `scale` the size of a
/// dot.
void draw_label(Image& image, int x, int y, std::string_view text, int scale);

}  // namespace crest
