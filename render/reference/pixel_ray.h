#pragma once

#include <glm/vec2.hpp>
#include <optional>

#include "render/reference/cell_walk.h"
#include "render/scene/camera.h"
#include "render/volume/clip.h"

namespace crest::reference {

/// What the rays of a picture's pixels are made from.
struct PixelRays {
  RayFrame frame;
  glm::ivec2 size;
  glm::dvec3 cell_size;  ///< in smallest spacings
  glm::dvec3 low, high;  ///< the rendered box, in cells
  glm::ivec3 cells;
};
PixelRays pixel_rays(const Grid& grid, const std::optional<ClipBox>& clip, const Camera& camera,
                     glm::ivec2 size);

template <class Real>
struct PixelRay {
  std::optional<CellRay<Real>> inside;  ///< its part in the box and before the eye, if there is one
  double depth = 0;              ///< of that part's entry, from where the ray begins; in smallest spacings
  glm::dvec3 float_rounding{0};  ///< of its positions, were they in 32-bit float; in cells
  bool grazes_box = false;       ///< whether it meets the box is within that rounding
};

/// The ray through the centre of a pixel (row 0 at the top), x(t) = origin + t direction, cut to the rendered
/// box and to t >= that of the eye. It is counted from the anchor plane (camera.h), not from the eye.
template <class Real>
PixelRay<Real> pixel_ray(const PixelRays& rays, int x, int y);

}  // namespace crest::reference
