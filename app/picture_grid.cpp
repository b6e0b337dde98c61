#include "app/picture_grid.h"

#include "app/labels.h"

namespace crest {

Image picture_grid(const std::vector<LabelledImage>& pictures, int columns, glm::vec3 background) {
  const glm::ivec2 size = pictures.front().image.size;
  const int gap = 2, rows = (int(pictures.size()) + columns - 1) / columns;
  Image grid;
  grid.size = {columns * size.x + (columns - 1) * gap, rows * size.y + (rows - 1) * gap};
  grid.pixels.assign(std::size_t(grid.size.x) * std::size_t(grid.size.y), glm::vec4(0.35f, 0.35f, 0.35f, 1));
  for (int i = 0; i < int(pictures.size()); ++i) {
    Image picture = over_background(pictures[std::size_t(i)].image, background);
    draw_label(picture, 0, 0, pictures[std::size_t(i)].label, size.x >= 400 ? 2 : 1);
    const glm::ivec2 corner(i % columns * (size.x + gap), i / columns * (size.y + gap));
    for (int y = 0; y < size.y; ++y)
      for (int x = 0; x < size.x; ++x) grid.at(corner.x + x, corner.y + y) = picture.at(x, y);
  }
  return grid;
}

}  // namespace crest
