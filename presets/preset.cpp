#include "presets/preset.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include <fmt/core.h>

#include "presets/choices.h"
#include "presets/names.h"

namespace crest {

Rendering with_trilinear_filters(Rendering rendering) {
  if (!is_trilinear(rendering.filter)) rendering.filter = Filter::linear;
  if (rendering.root_filter && !is_trilinear(*rendering.root_filter)) rendering.root_filter.reset();
  return rendering;
}

std::string why_inconsistent(const Rendering& rendering) {
  if (is_analytic(rendering.classification))
    for (const auto& [field, filter] :
         {std::pair("filter", rendering.filter),
          std::pair("root_filter", rendering.root_filter.value_or(rendering.filter))})
      if (!is_trilinear(filter))
        return fmt::format(
            "rendering.{}: classification analytic solves trilinear fields, of the filters linear and "
            "linear_exact; {} is sampled, by classification preintegrated or post",
            field, name_of(filter));
  if (!holds_one_length(rendering.classification)) return "";
  const auto complaint = [](std::string_view field, std::string_view wanted, std::string_view is) {
    return fmt::format(
        "rendering.{0}: the pre-integrated table holds steps of one length, which takes {0} {1}, not {2} "
        "(classification preintegrated has no such limit)",
        field, wanted, is);
  };
  if (!has_equal_steps(rendering.sampling))
    return complaint("sampling", name_of(Sampling::uniform), name_of(rendering.sampling));
  if (rendering.adaptive) return complaint("adaptive", "false", "true");
  if (rendering.placement != Placement::entry)
    return complaint("placement", name_of(Placement::entry), name_of(rendering.placement));
  return "";
}

double half_height_at_target(const Camera& camera) {
  return glm::length(camera.target - camera.eye) * std::tan(camera.fov_y_degrees * std::numbers::pi / 360);
}

}  // namespace crest
