#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "presets/preset.h"
#include "render/volume/volume.h"

namespace crest {

/// A picture's width by its height.
inline double aspect_of(glm::ivec2 size) { return double(size.x) / double(size.y); }

/// A camera that has the whole volume in view, from an oblique direction, with z up. In a picture of this
/// aspect (width by height) the box is in the middle, and takes 90 % of the width or of the height, whichever
/// is the tighter; less in views so wide that all of it is in view from a thousandth of its depth before its
/// nearest corner. The target is as far away as the box's middle.
Camera whole_volume_camera(const Grid& grid, double aspect, double fov_y_degrees = 30,
                           Projection projection = Projection::perspective);

/// The preset's camera, or the one that has the whole volume in view.
Camera camera_of(const Preset& preset, const Grid& grid, double aspect);

/// A camera's axes: orthonormal, w forward, u right, v up. An `up` along the view is replaced by another
/// axis.
struct CameraFrame {
  glm::dvec3 u, v, w;
};
/// Throws Error when eye and target are the same, or a number is not finite.
CameraFrame camera_frame(const Camera& camera);

/// Half the height of what is in view so far before the eye, in world units.
struct HalfHeight {
  double at_eye, slope;  ///< in perspective 0 at the eye, in parallel projection the same everywhere
  double operator()(double depth) const { return at_eye + slope * depth; }
};
/// Throws Error when the field of view is not in (0, 180) degrees.
HalfHeight half_height(const Camera& camera);

/// The rays of a picture, in units of the smallest spacing and from the box's first point. A pixel at (x, y)
/// of the image plane, each in [-1, 1], has the ray through anchor + x*anchor_u + y*anchor_v along w + x*u +
/// y*v. The anchor plane goes through the box's middle, so that a far eye costs no precision; or the eye,
/// if it is in the sphere around the box or behind it, so that rays from a face or a corner begin there
/// exactly. In parallel projection u and v are 0, and in place of the eye the rays begin on a plane that
/// touches that sphere.
struct RayFrame {
  glm::dvec3 anchor, anchor_u, anchor_v;
  glm::dvec3 w, u, v;
  double eye_to_anchor;
  double pixel;  ///< its diagonal: at distance 1 from the eye, or in parallel projection everywhere
};
RayFrame ray_frame(const Camera& camera, const Grid& grid, glm::ivec2 image_size);

}  // namespace crest
