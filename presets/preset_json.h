#pragma once

#include <string_view>

#include "presets/json_text.h"
#include "presets/preset.h"

namespace crest {

/// Which fields are written: those that differ from their default and a few that always tell, or each one.
enum class Fields { telling, all };

Json preset_to_json(const Preset& preset, Fields which);
Json camera_to_json(const Camera& camera, Fields which);

/// Throws Error "JSON.path: what is wrong".
Preset preset_from_json(Json json);

inline constexpr std::string_view preset_format = "crest-preset";
inline constexpr int preset_version = 1;

}  // namespace crest
