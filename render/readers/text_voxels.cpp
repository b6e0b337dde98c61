#include "render/readers/text_voxels.h"

#include <fmt/core.h>

#include <charconv>
#include <cmath>
#include <cstring>
#include <limits>

#include "presets/error.h"
#include "render/files/header_text.h"

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

template <class T>
void read_numbers_as(const std::string& name, WordStream& words, TextRange range, std::vector<std::byte>& out,
                     std::uint64_t done) {
  std::uint64_t wrong = 0;
  std::string first_wrong;
  std::string_view word;
  for (std::uint64_t i = 0; i < range.count;) {
    if (!words.next(word)) {
      throw Error(fmt::format("{}: the header promises {} numbers of voxels, and the file has {}", name,
                              done + range.count, done + i));
    }
    word = without_commas(word);
    if (word.empty()) continue;
    T value{};
    const Parsed parsed = parse(word, value);
    const auto place = [&] {
      return fmt::format("\"{}\" at voxel {} (line {})", shown(word), done + i, words.line());
    };
    if (parsed == Parsed::no_number) throw Error(fmt::format("{}: {} is not a number", name, place()));
    if (parsed == Parsed::not_of_the_type && wrong++ == 0) first_wrong = place();
    if (i >= range.first && i - range.first < range.taken) {
      const auto* bytes = reinterpret_cast<const std::byte*>(&value);
      out.insert(out.end(), bytes, bytes + sizeof value);
    }
    ++i;
  }
  if (wrong == 0) return;
  throw Error(fmt::format("{}: {} of its numbers {} no {}: the first is {}", name, wrong,
                          wrong == 1 ? "is" : "are", name_of(range.type), first_wrong));
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

void read_numbers(const std::string& name, WordStream& words, TextRange range, std::vector<std::byte>& out,
                  std::uint64_t done) {
  using enum ScalarType;
  switch (range.type) {
    case uint8:
      return read_numbers_as<std::uint8_t>(name, words, range, out, done);
    case int8:
      return read_numbers_as<std::int8_t>(name, words, range, out, done);
    case uint16:
      return read_numbers_as<std::uint16_t>(name, words, range, out, done);
    case int16:
      return read_numbers_as<std::int16_t>(name, words, range, out, done);
    case uint32:
      return read_numbers_as<std::uint32_t>(name, words, range, out, done);
    case int32:
      return read_numbers_as<std::int32_t>(name, words, range, out, done);
    case uint64:
      return read_numbers_as<std::uint64_t>(name, words, range, out, done);
    case int64:
      return read_numbers_as<std::int64_t>(name, words, range, out, done);
    case float32:
      return read_numbers_as<float>(name, words, range, out, done);
    case float64:
      return read_numbers_as<double>(name, words, range, out, done);
    case float16:
      break;
  }
  throw Error(fmt::format("{}: half-precision numbers as text are not read", name));
}

}  // namespace crest
