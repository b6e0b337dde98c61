#pragma once

#include "presets/preset.h"

namespace crest {

/// A mode's name for people; `name_of` is the one in files.
constexpr const char* title_of(Mode mode) {
  switch (mode) {
    case Mode::dvr_only:
      return "Volume";
    case Mode::peak_only:
      return "Surfaces";
    case Mode::peak_xor_dvr:
      return "Surfaces + volume";
    case Mode::both:
      break;
  }
  return "Surfaces + whole volume";
}

/// What a mode shows, in one line.
constexpr const char* explanation_of(Mode mode) {
  switch (mode) {
    case Mode::dvr_only:
      return "Samples alone: narrow peaks slip between them";
    case Mode::peak_only:
      return "The surfaces at the curve's peaks alone";
    case Mode::peak_xor_dvr:
      return "Surfaces, and samples of the rest: no spike twice";
    case Mode::both:
      break;
  }
  return "Samples and surfaces together";
}

/// The same of its exact picture.
constexpr const char* exact_explanation_of(Mode mode) {
  switch (mode) {
    case Mode::dvr_only:
      return "the integral of the whole curve";
    case Mode::peak_only:
      return "all surfaces at the curve's peaks, alone";
    case Mode::peak_xor_dvr:
      return "all surfaces, and the integral of the rest";
    case Mode::both:
      break;
  }
  return "the integral of the whole curve, and all surfaces";
}

}  // namespace crest
