#pragma once

#include "app/scene_options.h"

namespace crest {

struct CompareOptions {
  SceneOptions scene;
  PictureOptions picture;
};

/// Renders the four modes side by side, labelled, into one picture. Throws Error.
void compare_modes(const CompareOptions& options);

}  // namespace crest
