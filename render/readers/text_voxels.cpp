#include "render/readers/text_voxels.h"

#include <fmt/core.h>

#include <charconv>
#include <cmath>
#include <cstring>
#include <limits>

#include "presets/error.h"
#include "render/files/header_text.h"
#include "render/volume/convert.h"

namespace crest {
namespace {

bool is_blank(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

enum class Parsed { number, no_number, not_of_the_type };

/// from_chars, with a "+" before the number, and infinite where it is too great, 0 where it is too small.
template <class T>
Parsed parse_real(std::string_view word, T& value) {
  if (word.starts_with('+')) word.remove_prefix(1);
  if (word.starts_with('+') || word.empty()) return Parsed::no_number;
  const char* const end = word.data() + word.size();
  const auto [stop, fault] = std::from_chars(word.data(), end, value);
  if (stop != end || fault == std::errc::invalid_argument) return Parsed::no_number;
  if (fault == std::errc()) return Parsed::number;
  // Out of range: one of more digits tells on which side
  long double wide = 0;
  const auto again = std::from_chars(word.data(), end, wide);
  if (again.ec == std::errc()) {
    value = T(wide);
    return Parsed::number;
  }
  const bool negative = word.starts_with('-');
  const std::size_t exponent = word.find_first_of("eE");
  const bool small =
      exponent != std::string_view::npos && exponent + 1 < word.size() && word[exponent + 1] == '-';
  const T magnitude = small ? T(0) : std::numeric_limits<T>::infinity();
  value = negative ? -magnitude : magnitude;
  return Parsed::number;
}

/// A whole number of the type, also as "7.0" or "1e3".
template <class T>
Parsed parse_whole(std::string_view word, T& value) {
  const std::string_view digits = word.starts_with('+') ? word.substr(1) : word;
  const char* const end = digits.data() + digits.size();
  const auto [stop, fault] = std::from_chars(digits.data(), end, value);
  if (stop == end && fault == std::errc() && !digits.empty()) return Parsed::number;
  long double real = 0;
  if (parse_real(word, real) == Parsed::no_number) return Parsed::no_number;
  static_assert(std::numeric_limits<long double>::digits >= 64);  // holds every 64-bit integer
  const bool fits = std::isfinite(real) && real == std::floor(real) &&
                    real >= static_cast<long double>(std::numeric_limits<T>::min()) &&
                    real <= static_cast<long double>(std::numeric_limits<T>::max());
  if (!fits) return Parsed::not_of_the_type;
  value = T(real);
  return Parsed::number;
}

template <class T>
Parsed parse(std::string_view word, T& value) {
  if constexpr (std::is_integral_v<T>)
    return parse_whole(word, value);
  else
    return parse_real(word, value);
}

/// NRRD allows commas beside the space between numbers, not in its place.
std::string_view without_commas(std::string_view word) {
  while (word.starts_with(',')) word.remove_prefix(1);
  while (word.ends_with(',')) word.remove_suffix(1);
  return word;
}

std::string shown(std::string_view word) {
  constexpr std::size_t most = 40;
  std::string text = one_line(word.substr(0, most));
  for (char& c : text) c = static_cast<unsigned char>(c) < 0x80 ? c : '?';
  return word.size() > most ? text + "..." : text;
}

}  // namespace

bool WordStream::refill() {
  constexpr std::size_t block_size = std::size_t(1) << 18;
  block_.erase(0, at_);
  dropped_ += at_;
  at_ = 0;
  const std::size_t kept = block_.size();
  block_.resize(kept + block_size);
  stream_.read(block_.data() + kept, std::streamsize(block_size));
  block_.resize(kept + std::size_t(stream_.gcount()));
  return block_.size() > kept;
}

bool WordStream::next(std::string_view& word) {
  for (;; ++at_) {
    if (at_ == block_.size() && !refill()) return false;
    if (!is_blank(block_[at_])) break;
    line_ += block_[at_] == '\n';
  }
  std::size_t end = at_ + 1;
  for (; end - at_ < longest_word; ++end) {
    if (end == block_.size()) {
      const std::size_t length = end - at_;
      const bool more = refill();  // which moves the word to the block's begin
      end = at_ + length;
      if (!more) break;
    }
    if (is_blank(block_[end])) break;
  }
  word = std::string_view(block_).substr(at_, end - at_);
  at_ = end;
  return true;
}

NumberReader::NumberReader(std::string name, WordStream& words, ScalarType type, std::uint64_t count,
                           std::uint64_t done)
    : name_(std::move(name)), words_(words), type_(type), count_(count), done_(done) {
  if (type == ScalarType::float16)
    throw Error(fmt::format("{}: half-precision numbers as text are not read", name_));
}

template <class T>
void NumberReader::take_as(std::uint64_t numbers, std::byte* out) {
  std::string_view word;
  for (const std::uint64_t end = taken_ + numbers; taken_ < end;) {
    if (!words_.next(word)) {
      throw Error(fmt::format("{}: the header promises {} numbers of voxels, and the file has {}", name_,
                              done_ + count_, done_ + taken_));
    }
    word = without_commas(word);
    if (word.empty()) continue;
    T value{};
    const bool in_pieces = word.size() == WordStream::longest_word;
    const Parsed parsed = in_pieces ? Parsed::no_number : parse(word, value);
    const auto place = [&] {
      return fmt::format("\"{}\" at voxel {} (line {})", shown(word), done_ + taken_, words_.line());
    };
    if (parsed == Parsed::no_number) throw Error(fmt::format("{}: {} is not a number", name_, place()));
    if (parsed == Parsed::not_of_the_type && wrong_++ == 0) first_wrong_ = place();
    if (out) {
      std::memcpy(out, &value, sizeof value);
      out += sizeof value;
    }
    ++taken_;
  }
}

void NumberReader::take(std::uint64_t numbers, std::byte* out) {
  with_scalar_type(type_, [&](auto zero) {
    using T = decltype(zero);
    if constexpr (std::is_arithmetic_v<T>) take_as<T>(numbers, out);
  });
}

void NumberReader::finish() {
  skip(count_ - taken_);
  if (wrong_ == 0) return;
  throw Error(fmt::format("{}: {} of its numbers {} no {}: the first is {}", name_, wrong_,
                          wrong_ == 1 ? "is" : "are", name_of(type_), first_wrong_));
}

void read_numbers(const std::string& name, WordStream& words, ScalarType type, std::span<std::byte> out) {
  NumberReader numbers(name, words, type, out.size() / size_of(type));
  numbers.read(out);
  numbers.finish();
}

}  // namespace crest
