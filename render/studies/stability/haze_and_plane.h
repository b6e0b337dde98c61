#pragma once

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <vector>

#include "render/studies/stability/scenes.h"

namespace crest::stability {

/// A scene whose picture is known for every camera: blue haze of one material all through the box, and a
/// plane red surface in it, the true spike of a TF at an isovalue of a linear field. What a ray sees is T1 =
/// (1-h)^(L1/unit) of what lies behind the haze before the surface, and so on.
struct HazeAndPlane {
  Grid grid = cube(17);
  glm::ivec3 weights{1, 2, 4};   ///< the field at point (i,j,k) is their dot product: exact in float32
  double isovalue_share = 0.45;  ///< of the field's range
  double haze_opacity = 0.2, unit_distance = 8;  ///< h
  double surface_opacity = 0.5;

  double isovalue() const;
};

/// In DVR_ONLY the TF has no spike: haze alone.
Scene scene_of(const HazeAndPlane& haze, Mode mode, double step = 0.5);

/// The pixels of the picture, worked out in double.
std::vector<glm::dvec4> truth_of(const HazeAndPlane& haze, Mode mode, const Camera& camera, glm::ivec2 size);

/// Pixels whose rays enter or leave the box within the rounding of a position from the surface: there a
/// crossing more or less is right.
std::vector<bool> surface_at_an_end(const HazeAndPlane& haze, const Camera& camera, glm::ivec2 size);

}  // namespace crest::stability
