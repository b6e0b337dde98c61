#pragma once

#include <filesystem>

#include "render/measure/sweep.h"

namespace crest {

/// The measurer of a scene as a camera sees it: the ray caster in the GL 4.5 context that is current wherever
/// it is called and dies, and the exact answer on the CPU, which is kept in the folder `cache` (see
/// reference/cache.h).
Measurer measure_scene(Scene scene, Camera camera, glm::ivec2 size, std::filesystem::path cache);

}  // namespace crest
