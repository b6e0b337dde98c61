#include "render/volume/convert.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstring>

namespace crest {
namespace {
using Range = tbb::blocked_range<std::size_t>;
constexpr std::size_t grain = std::size_t(1) << 16;

}  // namespace

void convert_to_float(std::span<const std::byte> bytes, ScalarType type, std::size_t stride,
                      std::span<float> out, LinearMap map) {
  with_scalar_type(type, [&](auto zero) {
    using T = decltype(zero);
    tbb::parallel_for(Range(0, out.size(), grain), [&](const Range& part) {
      for (std::size_t i = part.begin(); i != part.end(); ++i) {
        T value;
        std::memcpy(&value, bytes.data() + i * stride * sizeof(T), sizeof(T));
        out[i] = mapped_to_float(value, map);
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
