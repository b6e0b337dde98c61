#pragma once

#include <glm/vec2.hpp>
#include <string>
#include <vector>

#include "render/measure/measurement.h"

namespace crest {

/// How the measurement in the background stands, and what it has found so far.
struct AccuracyResults {
  bool is_on = false;  ///< the person wants it: it begins again when the scene or the view changes
  bool is_running = false;
  bool is_stale = false;              ///< what was measured is not what the document shows now
  std::string doing;                  ///< "exact answer 'integral'", "dvr at step 0.25"; empty at rest
  double done = 0;                    ///< how far it is with that, in [0, 1]
  std::string error;                  ///< why it ended early; empty if it did not
  Rendering rendering;                ///< of the scene as it was measured: its filters are the methods' own
  glm::ivec2 size{0};                 ///< pixels of the measured pictures
  std::string renderer;               ///< as the driver names itself
  std::vector<Measurement> measured;  ///< in the order in which they came
  std::vector<LeftOut> left_out;
  /// How far the exact answers lie from the integral of the whole TF in the scene's own field: not errors.
  std::vector<AnswerError> model_differences;
};

}  // namespace crest
