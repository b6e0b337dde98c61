#pragma once

#include <memory>

#include "render/measure/choose_setting.h"
#include "render/renderer.h"

namespace crest {

/// The probe of a scene as a camera sees it in pictures of a size. The renderer's GL 4.5 context is current
/// wherever the probe is called and dies.
SceneProbe probe_scene(std::shared_ptr<Renderer> renderer, Scene scene, Camera camera, glm::ivec2 size);

}  // namespace crest
