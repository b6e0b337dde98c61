#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace crest {

/// Text of any origin as a terminal, or a window, may show it, in one line: line ends and tabs are spaces;
/// other control characters (of Unicode too: C1, and those that turn the direction), and what is no UTF-8,
/// are written as \xNN. What is longer than `longest` bytes, three at least, is cut to that, and
/// ends with "...". What is printable stays as it is.
std::string printable(std::string_view text, std::size_t longest = 2000);

/// A character of UTF-8 (RFC 3629): its number and its bytes; 0 bytes where there is none.
struct Character {
  std::uint32_t number = 0;
  std::size_t bytes = 0;
};

/// Of a text that is not empty.
Character first_character(std::string_view text);

/// Whether a terminal would obey it: of ASCII, of C1, line ends, and those that turn the direction.
bool is_control(std::uint32_t character);

/// Whether all of a text is UTF-8 (RFC 3629).
bool is_utf8(std::string_view text);

}  // namespace crest
