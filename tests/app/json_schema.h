#pragma once

#include <string>
#include <vector>

#include "presets/json.h"

namespace crest::test {

/// What in `json` is not as the JSON Schema `schema` says, each with its path. Of the standard it knows what
/// the schemas in docs/ use, and tells of any other keyword as a fault.
std::vector<std::string> schema_faults(const nlohmann::json& json, const nlohmann::json& schema);

}  // namespace crest::test
