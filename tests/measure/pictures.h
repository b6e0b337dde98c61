#pragma once

#include <glm/vec3.hpp>
#include <random>

#include "render/reference/reference.h"

namespace crest::testing {

inline Image filled(glm::ivec2 size, glm::vec4 color) {
  return {size, std::vector<glm::vec4>(std::size_t(size.x * size.y), color)};
}

/// The picture as an exact answer, without crossings or grazing pixels.
inline Reference as_exact(const Image& image) {
  Reference exact;
  exact.size = image.size;
  for (const glm::vec4& pixel : image.pixels) exact.pixels.emplace_back(pixel);
  exact.crossings.assign(image.pixels.size(), 0);
  exact.grazing.assign(image.pixels.size(), 0);
  return exact;
}

/// Opaque and coarse: squares of random colours.
inline Image random_squares(glm::ivec2 size, int side, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> unit(0, 1);
  Image image = filled(size, glm::vec4(1));
  for (int y = 0; y < size.y; y += side)
    for (int x = 0; x < size.x; x += side) {
      const glm::vec4 color(unit(random), unit(random), unit(random), 1);
      for (int j = y; j < std::min(y + side, size.y); ++j)
        for (int i = x; i < std::min(x + side, size.x); ++i) image.at(i, j) = color;
    }
  return image;
}

}  // namespace crest::testing
