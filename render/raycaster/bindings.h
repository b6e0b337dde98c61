#pragma once

#include <epoxy/gl.h>

#include "render/raycaster/need.h"
#include "render/resources/resources.h"
#include "render/scene/scene.h"

namespace crest {

/// Gives a variant of the ray caster, made for need.features, all that it reads of the scene: textures,
/// buffers, and the uniforms that go with them. What is not held yet is made. Throws Error where the driver
/// has no room.
void bind_scene(Resources& resources, const Scene& scene, const Classification& classification,
                const Need& need, GLuint program);

/// bc_weights, of the filter `bc` (shaders/filter_bc.glsl).
void set_bc_weights(GLuint program, const Rendering& rendering);

}  // namespace crest
