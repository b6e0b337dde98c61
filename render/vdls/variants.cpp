#include "render/vdls/variants.h"

#include <fmt/core.h>

#include "presets/choices.h"
#include "render/shader_inputs/blend_mode.h"
#include "render/shader_inputs/features.h"

namespace crest {

bool is_shaded(const Rendering& rendering) {
  return takes_gradient(rendering.shading) && !shows_values(rendering.blend_mode);
}

std::vector<std::string> setup_defines(const Rendering& rendering, bool counts) {
  Features features;
  features.blend_mode = rendering.blend_mode;
  std::vector<std::string> defines = shader_defines(features);
  defines.push_back(fmt::format("COUNTS {:d}", counts));
  defines.push_back(fmt::format("BACK_TO_FRONT {:d}", rendering.vdls.back_to_front));
  return defines;
}

std::vector<std::string> layers_defines(const Rendering& rendering, bool has_whole_values) {
  Features features;
  features.whole_values = has_whole_values;
  features.dvr = true;
  features.shading = is_shaded(rendering);
  features.blend_mode = rendering.blend_mode;
  std::vector<std::string> defines = shader_defines(features);
  defines.push_back(fmt::format("LAYERS {}", rendering.vdls.layers_per_pass));
  defines.push_back(fmt::format("GRADIENT_VOLUME {:d}", features.shading && rendering.vdls.gradient_volume));
  defines.push_back(fmt::format("EARLY_TEST {:d}", rendering.vdls.early_test));
  defines.push_back(fmt::format("BACK_TO_FRONT {:d}", rendering.vdls.back_to_front));
  return defines;
}

}  // namespace crest
