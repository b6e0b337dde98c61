#include "render/scene/exact.h"

#include <fmt/core.h>

#include "presets/choices.h"
#include "presets/names.h"

namespace crest {

std::string why_not_exact(const Rendering& rendering) {
  if (rendering.blend_mode != BlendMode::semi_transparent && shows_dvr(rendering.mode))
    return fmt::format("rendering.illumination is {}, which is made of samples",
                       name_of(rendering.blend_mode));
  Rendering exact = rendering;
  exact.classification = ClassificationMethod::analytic;
  return why_inconsistent(exact);
}

Rendering exact_rendering(Rendering rendering) {
  rendering.classification = ClassificationMethod::analytic;
  rendering.engine = Engine::raycaster;
  rendering.early_termination = 0;
  return rendering;
}

bool is_exact(const Rendering& rendering) {
  return is_analytic(rendering.classification) && rendering.engine == Engine::raycaster &&
         rendering.early_termination == 0 && why_not_exact(rendering).empty();
}

}  // namespace crest
