#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace crest {

/// The "key=value&..." that may follow a volume's name.
using Query = std::map<std::string, std::string, std::less<>>;

/// Throws Error, which begins with `name`, for a part without "=" or a key that is there twice.
Query parse_query(std::string_view name, std::string_view text);

/// Throws Error for a key of `query` that is not one of `known` (comma-separated).
void require_known_keys(std::string_view name, const Query& query, std::string_view known);

/// The parts between separators: at least one, and they may be empty.
std::vector<std::string_view> split(std::string_view text, char separator);

/// Whole texts as numbers; nothing when they are not that, or not finite.
std::optional<double> to_number(std::string_view text);
std::optional<std::int64_t> to_integer(std::string_view text);
/// Three numbers with `separator` between them.
std::optional<glm::dvec3> to_vector(std::string_view text, char separator);

/// The query's value of `key` as a number, or `fallback`; Error when it is not one or not in [min, max].
double number_in(std::string_view name, const Query& query, std::string_view key, double fallback, double min,
                 double max);
std::int64_t integer_in(std::string_view name, const Query& query, std::string_view key,
                        std::int64_t fallback, std::int64_t min, std::int64_t max);

}  // namespace crest
