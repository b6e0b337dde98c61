#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <optional>
#include <string>
#include <vector>

#include "render/measure/checked_crossings.h"
#include "render/reference/exact_ray.h"
#include "render/scene/traced_step.h"
#include "ui/view_content.h"

namespace crest {

/// A pixel of a view.
struct RayAsk {
  int view = 0;
  glm::ivec2 pixel{0}, size{0};  ///< row 0 at the top; of the picture
  bool operator==(const RayAsk&) const = default;
};

/// A ray in one mode: what is drawn as the settings have it, step by step, and the exact answer. Depths are
/// in world units, from the eye.
struct InspectedRay {
  ExactRay exact;
  std::vector<TracedStep> steps;
  std::string why_no_steps;  ///< e.g. that the march is exact; empty where there are steps
  CheckedCrossings crossings;
};

/// The same in all modes, in the order of view_modes; those that are there already.
struct RayInspection {
  RayAsk ask;
  std::array<std::optional<InspectedRay>, view_count> modes;
  std::array<std::string, view_count> errors;  ///< why a mode has none; empty while it is to come
};

/// What is under the mouse in a view.
struct PickedPixel {
  RayAsk ask;
  Picked picked;
};

}  // namespace crest
