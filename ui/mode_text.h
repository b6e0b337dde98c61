#pragma once

#include "presets/preset.h"

namespace crest {

/// How a mode is called, and in one line what it shows.
struct ModeText {
  Mode mode;
  const char* name;
  const char* explanation;
};

inline constexpr ModeText mode_texts[] = {
    {Mode::dvr_only, "DVR_ONLY", "Samples along the ray alone: narrow peaks slip between them"},
    {Mode::peak_only, "PEAK_ONLY", "The surfaces at the transfer function's peaks alone"},
    {Mode::peak_xor_dvr, "PEAK_XOR_DVR", "Surfaces where a step crosses a peak, else samples"},
    {Mode::both, "both", "Samples and surfaces together"},
};

constexpr const ModeText& mode_text(Mode mode) {
  for (const ModeText& text : mode_texts)
    if (text.mode == mode) return text;
  return mode_texts[0];
}

}  // namespace crest
