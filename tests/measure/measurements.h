#pragma once

#include "render/measure/measurement.h"

namespace crest::testing {

/// A point with the same error in all measures of pixels.
inline Measurement measurement(std::string method, double step, double ms, double error,
                               const ExactAnswer& answer = Answer::integral) {
  Measurement m;
  m.method = std::move(method);
  m.step = step;
  m.frame_ms = ms;
  m.frame_ms_all = {ms};
  ImageError e;
  e.compared = {.pixels = 100, .rmse = error, .max = error, .p999 = error, .share = error, .flip = error};
  m.errors = {{answer, e}};
  return m;
}

}  // namespace crest::testing
