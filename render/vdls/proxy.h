#pragma once

#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "render/vdls/quadtree.h"
#include "render/volume/clip.h"

namespace crest {

/// The part of the screen that is drawn, layer after layer: triangles, those that go through the most layers
/// first.
struct Proxy {
  std::vector<glm::vec2> corners;  ///< three a triangle, in pixels
  struct Part {
    int layers;
    int end;  ///< of its corners
  };
  std::vector<Part> parts;  ///< by falling layers

  int layers() const { return parts.empty() ? 0 : parts.front().layers; }
  /// How many corners, from the first on, go beyond this layer.
  int corners_beyond(int layer) const;
};

/// The quadtree's nodes, through as many layers as each has.
Proxy proxy_of(std::vector<ScreenNode> nodes);

/// The box's projection (VDLS, section 2: a convex polygon of 4 to 7 corners), a pixel wider all around so
/// that rounding loses no ray, through `layers` layers. What lies behind the eye is cut off.
Proxy proxy_of(const Box& box, const Camera& camera, glm::ivec2 size, int layers);

}  // namespace crest
