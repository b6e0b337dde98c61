#include "render/scene/exact.h"

#include <fmt/core.h>

#include "presets/choices.h"
#include "presets/names.h"

namespace crest {

std::string why_not_exact(const Rendering& rendering) {
  if (rendering.blend_mode != BlendMode::semi_transparent && shows_dvr(rendering.mode))
    return fmt::format("rendering.illumination is {}, which is made of samples",
                       name_of(rendering.blend_mode));
  return why_inconsistent(exact_rendering(rendering));
}

Rendering exact_rendering(const Rendering& rendering) {
  Rendering exact;
  exact.classification = ClassificationMethod::analytic;
  exact.mode = rendering.mode;
  exact.filter = rendering.filter;
  exact.root_filter = rendering.root_filter;
  exact.shading = rendering.shading;
  exact.gradient = rendering.gradient;
  exact.skipping = rendering.skipping;
  exact.clip_box = rendering.clip_box;
  exact.background = rendering.background;
  exact.unknown = rendering.unknown;
  return exact;
}

bool is_exact(const Rendering& rendering) {
  return is_analytic(rendering.classification) && rendering.engine == Engine::raycaster &&
         rendering.early_termination == 0 && why_not_exact(rendering).empty();
}

}  // namespace crest
