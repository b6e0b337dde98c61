#pragma once

#include <cstddef>
#include <cstdint>
#include <istream>
#include <span>
#include <string>
#include <string_view>

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

/// Reads `count` numbers of a text, each exactly rounded once, in the machine's byte order. `nan` and `inf`
/// are what they say; a number beyond the floating-point type is infinite. Throws Error, which begins with
/// `name`: for a word that is no number, with its voxel and line; for an early end.
class NumberReader {
 public:
  /// `done` numbers of the voxels are elsewhere, before these.
  NumberReader(std::string name, WordStream& words, ScalarType type, std::uint64_t count,
               std::uint64_t done = 0);
  void skip(std::uint64_t numbers) { take(numbers, nullptr); }
  void read(std::span<std::byte> out) { take(out.size() / size_of(type_), out.data()); }
  /// Reads what is left of them. Throws Error for numbers that an integer type does not have (300 in uint8,
  /// 1.5), how many there are of all that were read.
  void finish();
  std::uint64_t taken() const { return taken_; }

 private:
  void take(std::uint64_t numbers, std::byte* out);
  template <class T>
  void take_as(std::uint64_t numbers, std::byte* out);

  std::string name_;
  WordStream& words_;
  ScalarType type_;
  std::uint64_t count_, done_, taken_ = 0, wrong_ = 0;
  std::string first_wrong_;
};

/// All numbers of a text that are to fill `out`, as NumberReader reads them.
void read_numbers(const std::string& name, WordStream& words, ScalarType type, std::span<std::byte> out);

}  // namespace crest
