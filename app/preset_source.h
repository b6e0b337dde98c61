#pragma once

#include <string>

#include "presets/preset.h"

namespace crest {

/// Whether this is the name of a picture, which may hold the preset that it was made with.
bool is_picture_file(const std::string& source);

/// A preset from a file, from the library, or from a picture (.png, .exr) that was made with it;
/// "-" is the standard input. Throws Error.
Preset load_preset_from(const std::string& source);

/// What a picture keeps of what it shows: the preset with the camera in force.
std::string preset_for_picture(Preset preset, const Camera& camera);

}  // namespace crest
