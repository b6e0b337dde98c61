#include "render/volume/convert.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstring>

namespace crest {
namespace {
using Range = tbb::blocked_range<std::size_t>;
constexpr std::size_t grain = std::size_t(1) << 16;

/// Calls `f` with a value of the C++ type that `type` names.
template <class F>
void with_type(ScalarType type, F&& f) {
  switch (type) {
    case ScalarType::uint8:
      return f(std::uint8_t());
    case ScalarType::int8:
      return f(std::int8_t());
    case ScalarType::uint16:
      return f(std::uint16_t());
    case ScalarType::int16:
      return f(std::int16_t());
    case ScalarType::uint32:
      return f(std::uint32_t());
    case ScalarType::int32:
      return f(std::int32_t());
    case ScalarType::uint64:
      return f(std::uint64_t());
    case ScalarType::int64:
      return f(std::int64_t());
    case ScalarType::float64:
      return f(double());
    case ScalarType::float32:
      break;
  }
  return f(float());
}

}  // namespace

void convert_to_float(std::span<const std::byte> bytes, ScalarType type, std::size_t stride,
                      std::span<float> out, LinearMap map) {
  with_type(type, [&](auto zero) {
    using T = decltype(zero);
    tbb::parallel_for(Range(0, out.size(), grain), [&](const Range& part) {
      for (std::size_t i = part.begin(); i != part.end(); ++i) {
        T value;
        std::memcpy(&value, bytes.data() + i * stride * sizeof(T), sizeof(T));
        out[i] = map == LinearMap() ? float(value) : float(double(value) * map.slope + map.intercept);
      }
    });
  });
}

void swap_bytes(std::span<std::byte> bytes, std::size_t value_size) {
  if (value_size < 2) return;
  tbb::parallel_for(Range(0, bytes.size() / value_size, grain), [&](const Range& part) {
    for (std::size_t i = part.begin(); i != part.end(); ++i) {
      std::byte* const value = bytes.data() + i * value_size;
      std::reverse(value, value + value_size);
    }
  });
}

}  // namespace crest
