#pragma once

#include <deque>
#include <vector>

#include "presets/preset.h"
#include "render/scene/picture_cost.h"
#include "render/volume/clip.h"

namespace crest {

/// Rectangles of a tile of a picture, none over another, that hold every pixel whose ray meets one of the
/// boxes within `rendered`, all in world units. What else they hold is some pixels beside one; but where the
/// eye of a perspective camera is in a box, they are the whole tile.
std::vector<Tile> parts_that_meet(const std::vector<Box>& boxes, const Box& rendered, const Camera& camera,
                                  glm::ivec2 size, Tile tile);

/// The same for pictures that are drawn tile by tile, several in turn: each is projected once.
class PictureParts {
 public:
  std::vector<Tile> that_meet(const std::vector<Box>& boxes, const Box& rendered, const Camera& camera,
                              glm::ivec2 size, Tile tile);

 private:
  struct Known {
    std::vector<Box> boxes;
    Box rendered;
    Camera camera;
    glm::ivec2 size;
    std::vector<Tile> parts;
  };
  std::deque<Known> known_;  ///< the newest at the front
};

/// The box in so many equal ones that their rectangles follow its outline.
std::vector<Box> divided(const Box& box);

}  // namespace crest
