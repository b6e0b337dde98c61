#pragma once

#include <memory>
#include <string>

#include "render/scene/scene.h"

namespace crest {

/// A scene of the placement study, as one camera sees it. Only DVR is drawn.
struct PlacementScene {
  std::string id, title;  ///< for file names; for people
  std::string note;       ///< what it is to show
  Scene scene;
  Camera camera;
};

/// The square extruded to 5^3 points (the paper's fig. 4), seen so that the picture's middle row is the plane
/// study's. Its TF is white with tau = s/2, which is the paper's g / 2: opacity is linear between 33 points.
PlacementScene extruded_square();

/// A volume with data at its border (as the paper's fig. 5), and the same scene as a preset has it.
PlacementScene border_scene(const Scene& scene, const Camera& camera);
/// The built-in one: a gyroid, whole in a picture of this aspect (width by height).
PlacementScene builtin_border_scene(double aspect);

/// A plume, whose data end before its border but for its top; and the same with a clip box that cuts through
/// the data, on planes of points. `aspect` is the picture's.
PlacementScene whole_plume(double aspect);
PlacementScene clipped_plume(double aspect);

/// The points of the scene's volume in its clip box, as a volume of their own, and no clip box. Its planes
/// must be planes of points.
Scene cropped(const Scene& scene);

}  // namespace crest
