#pragma once

#include <epoxy/gl.h>

#include "render/scene/scene.h"

namespace crest {

/// What ray.glsl, placement.glsl and field.glsl ask of a program: the box, the grid, the camera of a picture
/// of `size` pixels, and the step. Throws Error for a camera that has no picture.
void set_view(GLuint program, const Scene& scene, const Camera& camera, glm::ivec2 size);

}  // namespace crest
