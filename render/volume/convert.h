#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/gtc/packing.hpp>
#include <span>

#include "render/volume/linear_map.h"
#include "render/volume/volume.h"

namespace crest {

/// A half-precision number as it is stored.
struct Half {
  std::uint16_t bits = 0;
  explicit operator float() const { return glm::unpackHalf1x16(bits); }
  explicit operator double() const { return double(float(*this)); }
};

/// Calls `f` with a value of the C++ type that `type` names.
template <class F>
void with_scalar_type(ScalarType type, F&& f) {
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
    case ScalarType::float16:
      return f(Half());
    case ScalarType::float32:
      break;
  }
  return f(float());
}

/// `out.size()` values of `type` as float32, mapped exactly and rounded once; `stride` is the distance
/// between them in `bytes`, in values (3 takes one component of RGB). `bytes` starts at the first value; it
/// need not be aligned.
void convert_to_float(std::span<const std::byte> bytes, ScalarType type, std::size_t stride,
                      std::span<float> out, LinearMap map = {});

/// Reverses the bytes of each value in place.
void swap_bytes(std::span<std::byte> bytes, std::size_t value_size);

}  // namespace crest
