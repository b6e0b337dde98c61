#pragma once

#include "render/classify/classification.h"
#include "render/resources/keyed_cache.h"
#include "render/scene/scene.h"

namespace crest {

/// What the TF brings in this scene, in its own units. Nothing is uploaded.
const Classification& classification_of(KeyedCache& held, const Scene& scene);

}  // namespace crest
