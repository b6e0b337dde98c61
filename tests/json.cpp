#include "tests/json.h"

#include <ostream>

nlohmann::json crest::test::parse_json(const std::string& text) { return nlohmann::json::parse(text); }

void nlohmann::PrintTo(const json& value, std::ostream* out) { *out << value.dump(); }
