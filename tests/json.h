#pragma once

#include <iosfwd>
#include <string>

#include "presets/json.h"

namespace crest::test {

/// json::parse, which is a template and is compiled once here, not in each file that parses. Throws as it
/// does.
nlohmann::json parse_json(const std::string& text);

}  // namespace crest::test

namespace nlohmann {

/// What GoogleTest prints: the text. Without it, each file compiles a printer of containers.
void PrintTo(const json& value, std::ostream* out);

}  // namespace nlohmann
