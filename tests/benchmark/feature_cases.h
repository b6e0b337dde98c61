#pragma once

#include <glm/vec2.hpp>
#include <optional>
#include <string>
#include <vector>

#include "render/raycaster/need.h"
#include "render/scene/scene.h"

namespace crest::bench {

/// A picture of the whole volume.
struct Frame {
  Scene scene;
  Forced forced = {};
  bool counts = false;     ///< whether costs are counted
  bool in_bricks = false;  ///< whether the device holds what shows of the volume
};

/// What a feature costs: the frame of a scene that needs it, and the frame of a scene as near to that as may
/// be which does not, with the feature forced in and without it.
struct FeatureCase {
  std::string feature;  ///< its name in all_features(), or what else is compared
  Frame needed, left_out;
  std::optional<Frame> forced_in = {};  ///< nothing where that would change the picture
};

/// Those that can be forced in, then the others.
std::vector<FeatureCase> feature_cases();

/// What the ray caster makes such a frame from. A GL context must be current, here and below.
Need need_of(const Frame& frame, glm::ivec2 size);

/// Why these cases do not compare what they say, in one line; or empty. Each of all_features() has one.
std::string fault_of(const std::vector<FeatureCase>& cases, glm::ivec2 size);

}  // namespace crest::bench
