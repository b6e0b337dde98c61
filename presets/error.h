#pragma once

#include <stdexcept>
#include <string>

namespace crest {

/// A failure that a person can act on. The text is one line: what is wrong, where, and what would be right.
/// It may quote anything: it is kept as printable() makes it.
struct Error : std::runtime_error {
  explicit Error(const std::string& text);
};

}  // namespace crest
