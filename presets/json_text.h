#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

namespace crest {

/// JSON whose keys keep their order.
using Json = nlohmann::ordered_json;

/// Parses JSON that anyone may have written. Throws Error: at a syntax error with its line and column, at a
/// number beyond double, a key that appears twice in an object, more than 64 levels or 1000 keys in one
/// object with the JSON path.
Json parse_json(std::string_view text);

/// The text of `json`, made to be read and compared by people: objects over several lines, but each element
/// of an array on one line. Ends with a newline.
std::string print_json(const Json& json);

/// For the standard output, indented; what is no UTF-8 in it is replaced.
std::string pretty(const Json& json);

/// One line of at most some forty characters, for messages.
std::string summary_of(const Json& json);

/// "a" and "b" make "a.b".
std::string join_path(std::string_view object, std::string_view key);

}  // namespace crest
