#pragma once

#include "presets/preset.h"

namespace crest {

/// What a mode shows, in one line.
constexpr const char* explanation_of(Mode mode) {
  switch (mode) {
    case Mode::dvr_only:
      return "Samples along the ray alone: narrow peaks slip between them";
    case Mode::peak_only:
      return "The surfaces at the transfer function's peaks alone";
    case Mode::peak_xor_dvr:
      return "Surfaces where a step crosses a peak, else samples";
    case Mode::both:
      break;
  }
  return "Samples and surfaces together";
}

}  // namespace crest
