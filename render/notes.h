#pragma once

#include <string>
#include <vector>

#include "render/files/image.h"
#include "render/scene/scene.h"

// Why a picture shows nothing, or little: sentences for the person who looks at it, whichever engine drew it.

namespace crest {

/// What is so before anything is drawn: no voxel has a value; all have the same; or no point of the TF lies
/// in the volume's range, and all lie on one side of it. Empty for ordinary scenes.
std::vector<std::string> scene_notes(const Scene& scene);

/// Whether a pixel of a picture differs from the background by half a step of an 8-bit file, or more.
bool has_visible_pixel(const Image& image, glm::vec3 background);

/// Why none does, in a picture of this size: the camera, the clip box, the TF. Throws Error for a camera that
/// has no picture.
std::string why_nothing_is_visible(const Scene& scene, const Camera& camera, glm::ivec2 size);

/// All that is to be said of a picture that was drawn.
std::vector<std::string> picture_notes(const Scene& scene, const Camera& camera, const Image& image);

}  // namespace crest
