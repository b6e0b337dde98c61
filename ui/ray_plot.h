#pragma once

#include <span>

#include "presets/peaks.h"
#include "ui/ray_inspection.h"
#include "ui/value_axis.h"
#include "ui/widgets.h"

namespace crest {

/// Two plots over one axis of depth: the field along the ray, with the surfaces' values, what the exact
/// answer crosses, and the samples that are taken; and the opacity that is collected, exactly and as drawn.
void draw_ray_plots(const InspectedRay& ray, std::span<const Peak> surfaces, const ValueAxis& depths,
                    ImVec2 low, ImVec2 size);

/// How much of the height the upper plot has.
inline constexpr float field_plot_share = 0.58F;

}  // namespace crest
