#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "render/scene/scene.h"

namespace crest {

/// A scene that chance made, and the kinds of which it is.
struct RandomScene {
  std::string field, features, view;  ///< "noise", "spikes", "inside": names of kinds.h
  bool labels = false;                ///< the field is of whole numbers that jump
  Scene scene;
  Camera camera;
};

inline constexpr int random_scene_count = 12;

/// Twelve scenes. In each seed's twelve every kind of field, of TF and of view is there equally often, joined
/// by chance. The same seed makes the same scenes on every machine.
std::vector<RandomScene> random_scenes(std::uint64_t seed);

}  // namespace crest
