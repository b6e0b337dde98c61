#pragma once

#include <string>

namespace crest {

/// As a person counts: slice2 before slice10, and slice02 where slice2 is. (strverscmp takes a number with
/// leading zeros for a fraction: slice02 before slice1.)
bool natural_less(const std::string& a, const std::string& b);

}  // namespace crest
