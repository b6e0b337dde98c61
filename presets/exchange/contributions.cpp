#include "presets/exchange/contributions.h"

#include "presets/choices.h"

namespace crest {

ShownContributions shown_contributions(const Preset& preset) {
  const Mode mode = preset.rendering.mode;
  ShownContributions shown{.dvr = preset.transfer_function, .shows_dvr = shows_dvr(mode), .surfaces = {}};
  const bool integrates =
      preset.rendering.blend_mode == BlendMode::semi_transparent;  // others show no surfaces
  if (!shows_surfaces(mode) || !integrates) return shown;
  const std::vector<Peak> peaks = find_peaks(shown.dvr);
  shown.surfaces = shown_peaks(peaks);
  if (is_exclusive(mode)) shown.dvr = base_transfer_function(shown.dvr, peaks);
  return shown;
}

}  // namespace crest
