#pragma once

#include <filesystem>
#include <string>

#include "presets/preset.h"

namespace crest {

/// What a person works on: a plain value. Everything in it can be undone.
struct Document {
  std::string volume_source;  ///< as load_volume takes it; empty while none is open
  Preset preset;
  std::filesystem::path preset_path;  ///< where it was opened from or saved to; empty while it has no file
  bool operator==(const Document&) const = default;
};

}  // namespace crest
