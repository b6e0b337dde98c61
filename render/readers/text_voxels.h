#pragma once

#include <cstddef>
#include <cstdint>
#include <istream>
#include <string>
#include <string_view>
#include <vector>

#include "render/volume/volume.h"

namespace crest {

/// Words of a stream, between white space, with their place. The stream is read in blocks, so a word lives
/// until the next one is asked for.
class WordStream {
 public:
  /// `line` is the number of the stream's first line.
  explicit WordStream(std::istream& stream, std::size_t line = 1) : stream_(stream), line_(line) {}
  /// Takes the next word; false at the end.
  bool next(std::string_view& word);
  /// Of the last word.
  std::size_t line() const { return line_; }
  /// Bytes of the stream up to the last word's end.
  std::uint64_t taken() const { return dropped_ + at_; }
  /// A word longer than this is no number; it is handed on in pieces.
  static constexpr std::size_t longest_word = 4096;

 private:
  bool refill();
  std::istream& stream_;
  std::string block_;
  std::uint64_t dropped_ = 0;
  std::size_t at_ = 0, line_ = 1;
};

/// What a text's numbers are read as, and where they go.
struct TextRange {
  ScalarType type = ScalarType::float32;
  std::uint64_t count = 0;             ///< numbers to be read
  std::uint64_t first = 0, taken = 0;  ///< those that are kept: [first, first + taken)
};

/// Reads `range.count` numbers, each exactly rounded once, and appends the bytes of those kept to `out`, in
/// the machine's order. `nan` and `inf` are what they say; a number beyond the floating-point type is
/// infinite. Throws Error, which begins with `name`: for a word that is no number, with its voxel and line;
/// for numbers that an integer type does not have (300 in uint8, 1.5), how many there are; for an early end.
/// `done` numbers were read before.
void read_numbers(const std::string& name, WordStream& words, TextRange range, std::vector<std::byte>& out,
                  std::uint64_t done = 0);

}  // namespace crest
