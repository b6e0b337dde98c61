#pragma once

#include <span>
#include <vector>

#include "render/reference/exact_ray.h"
#include "render/scene/traced_step.h"

namespace crest {

/// A crossing of the exact answer, and whether the steps found it.
struct CheckedCrossing {
  double depth = 0, value = 0;  ///< in world units; of the surface, as resolved
  bool found = false;
};

struct CheckedCrossings {
  std::vector<CheckedCrossing> exact;  ///< those in front of which the ray is not opaque, by ascending depth
  int invented = 0;                    ///< composited in a step, where the answer has none

  int missed() const;
};

/// Each step's crossings beside those that the exact answer has between its ends. Depths of both are from one
/// place. A crossing within a thousandth of a step from its end counts in either.
CheckedCrossings check_crossings(const ExactRay& exact, std::span<const TracedStep> steps);

}  // namespace crest
