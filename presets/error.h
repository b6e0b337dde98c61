#pragma once

#include <stdexcept>

namespace crest {

/// A failure that a person can act on. The text is one line: what is wrong, where, and what would be right.
struct Error : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace crest
