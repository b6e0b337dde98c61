#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <streambuf>

namespace crest {

/// The bytes that base64 text holds, as it goes on. White space is passed over; padding within it ends a
/// group of its own, since VTK joins several texts.
class Base64Reader {
 public:
  explicit Base64Reader(std::streambuf& text) : text_(text) {}
  /// Fills `out` as far as the text goes, and returns how far.
  std::size_t read(std::span<std::byte> out);

 private:
  bool next_group();

  std::streambuf& text_;
  std::uint32_t bits_ = 0;  ///< of the last group
  int left_ = 0;            ///< bytes of it
};

}  // namespace crest
