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
  std::string library_name;           ///< of the preset that it began as, while it has no file; or empty
  bool operator==(const Document&) const = default;
};

/// One that a person begins in the window: the default TF, with lit surfaces. The program's other commands
/// begin without light.
Preset new_preset();

/// What the preset is called in titles: its file's name, "onion (library)", or "new preset".
std::string preset_label(const Document& document);

/// Whether two are the same file, the same preset of the library, or both new ones.
bool is_same_preset_file(const Document& a, const Document& b);

/// Whether what was opened last is a preset; else it is a volume.
bool is_preset_name(const std::string& source);

/// What is behind the last slash, if anything is.
std::string file_name(const std::string& source);

}  // namespace crest
