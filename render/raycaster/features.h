#pragma once

#include <string>
#include <utility>
#include <vector>

#include "presets/preset.h"
#include "render/classify/classification.h"
#include "render/volume/volume.h"

namespace crest {

/// So many peaks are tested all at once, which takes less time than a look into the table.
inline constexpr int most_peaks_without_table = 4;

/// What a scene needs of the ray caster's shader: everything else is compiled out of it.
struct Features {
  bool dvr = false;         ///< DVR samples
  bool peaks = false;       ///< crossings of the peaks
  bool peak_table = false;  ///< candidates from the table: more peaks than are tested all at once
  bool one_peak = false;    ///< a single surface to test
  bool split = false;       ///< segments divided at their crossings
  bool extrema = false;     ///< surfaces entered and left within one step are looked for, too
  bool exclusive = false;   ///< in the paper's form: no DVR sample in a step with a crossing
  bool base_tf = false;     ///< DVR takes the TF without its spikes
  Placement placement = Placement::entry_exit_corner;
  bool clip_box = false;  ///< which takes something away from the volume
  bool shading = false;
  bool early_termination = false;
  bool empty_cells = false;  ///< the volume has voxels without a value
  bool statistics = false;

  bool operator==(const Features&) const = default;
};

/// One function decides: from the volume, the TF's peaks, the settings, and whether the costs are to be
/// counted.
Features needed_features(const Volume& volume, const Classification& classification,
                         const Rendering& rendering, bool statistics);

/// The shader's defines, as "NAME value"; the same features give the same list.
std::vector<std::string> shader_defines(const Features& features);

/// The names of what is in, and of what was left out with the reason, for people.
std::vector<std::string> feature_names(const Features& features);
std::vector<std::pair<std::string, std::string>> left_out(const Features& features, const Volume& volume,
                                                          const Classification& classification,
                                                          const Rendering& rendering);

}  // namespace crest
