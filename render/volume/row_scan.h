#pragma once

#include <algorithm>
#include <bit>
#include <cfloat>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>

// The innermost loops of a volume's statistics, over rows of values as they are stored. They have no branch a
// value, so that a compiler makes SIMD of them.

namespace crest {

/// How values of a type differ: integers of 8 and 16 bits exactly in 32 bits, floats exactly in double.
template <class T>
using DifferenceOf = std::conditional_t<std::is_same_v<T, float>, double, std::uint32_t>;

/// The larger of `so_far` and the largest of |b[i] - a[i]|.
template <class T>
std::uint32_t largest_difference(const T* a, const T* b, std::size_t count, std::uint32_t so_far) {
  using Unsigned = std::make_unsigned_t<T>;
  Unsigned largest = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const T low = a[i] < b[i] ? a[i] : b[i], high = a[i] < b[i] ? b[i] : a[i];
    const auto difference = Unsigned(Unsigned(high) - Unsigned(low));
    largest = difference > largest ? difference : largest;
  }
  return std::max<std::uint32_t>(so_far, largest);
}

/// Those bits of |b[i] - a[i]|, rounded to float, that are the largest: bits of floats that are not negative
/// are in their order, behind them Inf and NaN.
inline std::int32_t largest_difference_bits(const float* a, const float* b, std::size_t count) {
  std::int32_t largest = 0;
  for (std::size_t i = 0; i < count; ++i)
    largest = std::max(largest, std::bit_cast<std::int32_t>(b[i] - a[i]) & 0x7FFFFFFF);
  return largest;
}

/// Pairs without two finite values do not count: their difference is NaN or infinite, which no difference of
/// finite floats is in double. Rounding keeps the order, so only rows are looked at in double in which a
/// rounded difference is as large as the rounded one so far.
inline double largest_difference(const float* a, const float* b, std::size_t count, double so_far) {
  const std::int32_t bits = largest_difference_bits(a, b, count);
  if (bits == 0 || bits < std::bit_cast<std::int32_t>(float(so_far))) return so_far;
  for (std::size_t i = 0; i < count; ++i) {
    const double difference = std::abs(double(b[i]) - double(a[i]));
    if (difference > so_far && difference <= 2.0 * double(FLT_MAX)) so_far = difference;
  }
  return so_far;
}

/// Eight times, four or two: as many as a word of 64 bits holds.
template <class T>
std::uint64_t word_of(T value) {
  return std::uint64_t(std::make_unsigned_t<T>(value)) * (~std::uint64_t(0) / std::make_unsigned_t<T>(~T(0)));
}

/// Counts each value at counts[value - least of the type]. A word of one value, as of a background, counts
/// at once.
template <class T>
void count_row(const T* values, std::size_t count, std::uint64_t* counts) {
  constexpr std::size_t together = sizeof(std::uint64_t) / sizeof(T);
  constexpr int least = std::numeric_limits<T>::min();
  std::size_t i = 0;
  for (; i + together <= count; i += together) {
    std::uint64_t word;
    std::memcpy(&word, values + i, sizeof word);
    if (word == word_of(values[i])) {
      counts[values[i] - least] += together;
    } else {
      for (std::size_t j = i; j < i + together; ++j) ++counts[values[j] - least];
    }
  }
  for (; i < count; ++i) ++counts[values[i] - least];
}

/// Which of `count` cells have one value at all eight corners: 1 or 0. Their corners lie on four rows, each
/// of a value more. NaN equals nothing.
template <class T>
void mark_uniform_cells(const T* a, const T* b, const T* c, const T* d, std::size_t count,
                        std::uint8_t* marks) {
  for (std::size_t i = 0; i < count; ++i) {
    const T value = a[i];
    marks[i] = std::uint8_t((a[i + 1] == value) & (b[i] == value) & (b[i + 1] == value) & (c[i] == value) &
                            (c[i + 1] == value) & (d[i] == value) & (d[i + 1] == value));
  }
}

/// Calls visit(first, length) for each run of marks.
template <class Visit>
void for_each_run(const std::uint8_t* marks, std::size_t count, const Visit& visit) {
  const std::uint8_t* const end = marks + count;
  for (const std::uint8_t* at = marks; at != end;) {
    const auto* const first = static_cast<const std::uint8_t*>(std::memchr(at, 1, std::size_t(end - at)));
    if (!first) return;
    const void* const after = std::memchr(first, 0, std::size_t(end - first));
    at = after ? static_cast<const std::uint8_t*>(after) : end;
    visit(std::size_t(first - marks), std::size_t(at - first));
  }
}

}  // namespace crest
