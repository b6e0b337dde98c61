#pragma once

#include "presets/preset.h"

namespace crest {

/// The equal segments that a placement gives a ray; a sample lies in the middle of each.
struct Segments {
  int n = 0;                   ///< 0: the ray is not sampled
  double begin = 0, size = 0;  ///< of the first one; lengths along the ray

  double end() const { return begin + n * size; }
  double middle(int i) const { return begin + (i + 0.5) * size; }
};

/// Steneteg et al., Listings 1 to 4, for a ray that enters and leaves at these distances from the eye, all in
/// the step's unit: what shaders/placement.glsl does, in double. One length of step is used for all: the
/// listings count it from the number of points an axis (`dim`), but the last from that of cells (`dim - 1`).
Segments segments_of(Placement placement, double step, double enter, double exit);

}  // namespace crest
