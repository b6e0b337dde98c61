#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace crest {

/// The numbers of a text, separated by white space, commas or semicolons, with the point for a comma whatever
/// the locale. Nothing where one is not a finite number.
std::optional<std::vector<double>> to_numbers(std::string_view text);

/// Its lines, without their ends.
std::vector<std::string_view> lines_of(std::string_view text);

}  // namespace crest
