#pragma once

#include <string>
#include <vector>

#include "presets/preset.h"

namespace crest {

/// Whether VDLS shades its samples.
bool is_shaded(const Rendering& rendering);

/// The defines of vdls_setup.frag, as "NAME value"; `counts`: for a target that counts.
std::vector<std::string> setup_defines(const Rendering& rendering, bool counts);

/// And those of vdls_layers.frag, for a volume with whole values or another (volume/whole_values.h).
std::vector<std::string> layers_defines(const Rendering& rendering, bool has_whole_values);

}  // namespace crest
