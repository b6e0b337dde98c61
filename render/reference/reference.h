#pragma once

#include <cstdint>
#include <functional>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <vector>

#include "render/image.h"
#include "render/reference/answer.h"
#include "render/scene.h"

namespace crest {

/// Told the share that is done, in [0, 1], from any thread, one call at a time; false = stop.
using Progress = std::function<bool(double done)>;

/// Thrown when a Progress asked for a stop.
struct Cancelled {};

/// The exact picture.
struct Reference {
  glm::ivec2 size{0};
  std::vector<glm::dvec4> pixels;        ///< premultiplied RGBA, row 0 at the top
  std::vector<std::uint32_t> crossings;  ///< of the shown peaks' surfaces, by the pixel's ray
  /// 1 where the ray passes a surface's tangent, or a surface at the ray's end, within the rounding of 32-bit
  /// float: there a renderer in float may rightly count a crossing more or less. Such pixels are compared
  /// apart.
  std::vector<std::uint8_t> grazing;

  Image image() const;  ///< rounded to float
};

/// Solves every pixel's ray to `tolerance` (absolute, in each channel). Step, placement, shading and early
/// termination have no part in it; the clip box has. Throws Error, Cancelled.
Reference render_reference(const Scene& scene, const Camera& camera, glm::ivec2 size, Answer answer,
                           double tolerance = 1e-10, const Progress& progress = {});

}  // namespace crest
