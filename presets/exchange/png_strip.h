#pragma once

#include <glm/vec4.hpp>
#include <string>
#include <vector>

namespace crest {

/// A PNG of one row, 16 bits a channel: RGB, or RGBA that is not premultiplied, clamped to [0, 1].
std::string png_strip(const std::vector<glm::dvec4>& pixels, int channels);

}  // namespace crest
