#pragma once

#include <string>

namespace crest {

/// The JSON Schema (2020-12) of a preset, as text: made from the fields that are read and written (fields.h).
/// It is presets/preset.schema.json.
std::string preset_schema();

}  // namespace crest
