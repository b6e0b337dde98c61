#pragma once

#include <glm/vec2.hpp>
#include <optional>
#include <stop_token>
#include <vector>

#include "render/reference/answer.h"
#include "render/scene/camera.h"
#include "render/scene/scene.h"

namespace crest {

/// How much of a picture each value makes (Correa and Ma, Visibility histograms and visibility-driven
/// transfer functions, 2011): the opacity that places of this value add, times the transmittance in front of
/// them, a mean over the picture's pixels. All bins together are the picture's mean opacity.
struct Visibility {
  ValueRange range;             ///< of the volume; what a filter makes beyond it is in the bins at its ends
  std::vector<double> volume;   ///< in equal bins: what is integrated
  std::vector<double> surface;  ///< and what the surfaces add where they are crossed

  std::size_t bins() const { return volume.size(); }
};

inline constexpr int visibility_bins = 256;

/// Of the exact picture that the scene's mode and filters mean, as the camera sees it: the first of
/// answers_of(). Neither the step nor the placement nor light nor early termination has a part in it. Each
/// pixel's ray is solved to 1e-7 by the reference, with the TF cut at the bins' ends, so that nothing is
/// spread over two bins; a sparse picture will do. On all cores. Nothing when it was stopped.
///
/// Requires that why_without_answer() has nothing to say.
std::optional<Visibility> measure_visibility(const Scene& scene, const Camera& camera, glm::ivec2 size,
                                             int bins = visibility_bins, const std::stop_token& stop = {});

}  // namespace crest
