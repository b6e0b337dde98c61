#pragma once

#include "render/scene/scene.h"

namespace crest::testing {

/// A scene, and a camera that looks at it.
struct View {
  Scene scene;
  Camera camera;
};

/// A small one, with something of everything that decides what a picture needs: smooth, rough, integer and
/// constant fields, some with holes; wide peaks, spikes, steps and plateaus, within the data and beyond; all
/// modes and settings; cameras outside, inside and turned away. The same seed gives the same view.
View random_view(std::uint64_t seed);

/// One of them that the exact march draws.
View analytic_view(std::uint64_t seed);

}  // namespace crest::testing
