#pragma once

#include <string>
#include <vector>

#include "render/files/image.h"

namespace crest {

struct LabelledImage {
  Image image;
  std::string label;
};

/// Pictures of one size side by side, row by row, each with its label, over the background.
Image picture_grid(const std::vector<LabelledImage>& pictures, int columns, glm::vec3 background);

}  // namespace crest
