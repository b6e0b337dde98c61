#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "presets/preset.h"

namespace crest {

/// Reads a preset's JSON text (format "crest-preset", version 1). `source` names the text in errors.
/// Throws Error with the JSON path of the fault: "FILE: transfer_function.points[3].opacity: 1.2 is not in
/// [0, 1]". Only transfer_function.points is required, and value and opacity in each point. A text larger
/// than 16 MB, nested deeper than 64 levels, or with a key twice in one object is refused.
Preset parse_preset(std::string_view text, std::string_view source);

/// Whether a text is a preset of Crest's own: a JSON object with a transfer_function.
bool is_own_preset(std::string_view text);

/// The preset as JSON text: numbers round-trip exactly, unknown keys are written back. Optional fields are
/// written where they differ from their default (fields.h says which are always), a point to a line.
std::string write_preset(const Preset& preset);

/// Reads a file, or, when `name_or_path` has no such file, the preset of that name in the built-in library.
Preset load_preset(const std::string& name_or_path);

/// Writes the whole file or leaves what was there (see write_file_atomically).
void save_preset(const std::filesystem::path& path, const Preset& preset);

/// The preset with one field set by its JSON path: "rendering.step=0.5",
/// "transfer_function.points[1].value=3". The value is JSON; what is not JSON counts as a string;
/// "camera=null" takes the camera away. Throws Error as parse_preset, and for a field that there is not, with
/// those that there are.
Preset set_field(const Preset& preset, std::string_view path_and_value);

/// What set_field() takes, one field after the other, to make one rendering of another.
std::vector<std::string> assignments_between(const Rendering& from, const Rendering& to);

struct LibraryPreset {
  std::string_view name;  ///< the file's name without .json
  std::string_view text;
};
/// The presets that come with the program, sorted by name. All are normalized: they fit any volume.
std::vector<LibraryPreset> library();

}  // namespace crest
