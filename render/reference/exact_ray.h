#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "render/reference/solved_scene.h"
#include "render/scene/camera.h"

namespace crest {

/// A place on a pixel's ray, and what the exact answer has collected before it. Depths are in world units,
/// from where the ray begins (RayFrame).
struct RayPlace {
  double depth = 0;
  double value = 0;     ///< of the field that is integrated; NaN where the volume has no values
  glm::dvec3 color{0};  ///< premultiplied
  double opacity = 0;
  /// The value of the surface that was composited here, in the TF's resolved units.
  std::optional<double> surface;
};

/// The exact answer along one ray. Between two places the field is a part of one cell's polynomial.
struct ExactRay {
  double enter = 0, exit = 0;    ///< depths of the rendered box
  std::vector<RayPlace> places;  ///< by ascending depth; empty where the ray misses the box

  double value_at(double depth) const;    ///< between two places a straight line
  double opacity_at(double depth) const;  ///< of the last place that is not behind
};

/// Solves single rays of a picture.
class ExactRays {
 public:
  /// Throws Error for a camera that has no picture. `known`: of the volume, from rays that were made before.
  ExactRays(const Scene& scene, const Camera& camera, glm::ivec2 size, Answer answer,
            std::shared_ptr<const reference::EmptyCells> known = {});
  const std::shared_ptr<const reference::EmptyCells>& empty_cells() const {
    return solved_.fields.empty_cells;
  }
  /// The ray of a pixel, row 0 at the top.
  ExactRay at(glm::ivec2 pixel) const;

 private:
  Scene scene_;  ///< keeps the volume
  reference::SolvedScene<double> solved_;
  reference::PixelRays rays_;
};

/// What a person points at: the first surface on the ray, and the value that brings the most to its pixel.
struct Picked {
  std::optional<double> surface, surface_depth;
  std::optional<double> strongest;                  ///< where anything shows
  double strongest_depth = 0, strongest_share = 0;  ///< of the pixel's opacity
};
Picked pick(const ExactRay& ray);

}  // namespace crest
