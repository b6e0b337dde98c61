#pragma once

#include <string>

namespace crest {

/// A volume's source, or a preset's path, that means the same in every working folder. Built-in volumes stay
/// as they are.
std::string absolute_source(const std::string& source);

}  // namespace crest
