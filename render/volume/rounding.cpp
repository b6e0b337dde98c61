#include "render/volume/rounding.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace crest {
namespace {

double float_spacing(double value) {
  const float magnitude = float(std::abs(value));
  return double(std::nextafter(magnitude, std::numeric_limits<float>::infinity())) - double(magnitude);
}

template <class T>
Rounding rounding_of_type(std::span<const std::byte> bytes, std::size_t count, std::size_t stride,
                          LinearMap map) {
  const double step = std::is_integral_v<T> ? std::abs(map.slope) : 0;
  Rounding sum;
  for (std::size_t i = 0; i < count; ++i) {
    T stored;
    std::memcpy(&stored, bytes.data() + i * stride * sizeof(T), sizeof(T));
    const auto exact = mapped(stored, map);
    const double value = double(exact);
    if (!std::isfinite(value)) continue;
    sum.min = std::min(sum.min, value);
    sum.max = std::max(sum.max, value);
    const double change = double(std::abs(mapped_to_float(stored, map) - exact));
    if (change == 0 || float_spacing(value) <= step) continue;
    ++sum.merged;
    sum.largest_change = std::max(sum.largest_change, change);
  }
  return sum;
}

}  // namespace

Rounding joined(const Rounding& a, const Rounding& b) {
  return {std::min(a.min, b.min), std::max(a.max, b.max), a.merged + b.merged,
          std::max(a.largest_change, b.largest_change)};
}

bool may_round(ScalarType type, LinearMap map) {
  if (type == ScalarType::float32 || type == ScalarType::float16) return false;
  return size_of(type) >= 4 || map != LinearMap();
}

Rounding rounding_of(std::span<const std::byte> bytes, ScalarType type, std::size_t count, std::size_t stride,
                     LinearMap map) {
  Rounding rounding;
  with_scalar_type(type, [&](auto zero) {
    using T = decltype(zero);
    if constexpr (std::is_arithmetic_v<T>) rounding = rounding_of_type<T>(bytes, count, stride, map);
  });
  return rounding;
}

std::string rounding_note(const Rounding& rounding, ScalarType type, LinearMap map) {
  constexpr double few_levels = 4096, float_integers = 1 << 24;
  if (rounding.merged == 0) return {};
  const double width = rounding.max - rounding.min;
  const double spacing = float_spacing(std::max(std::abs(rounding.min), std::abs(rounding.max)));
  if (!is_integer(type) && (width == 0 || width / spacing >= few_levels)) return {};
  const double step = is_integer(type) ? std::abs(map.slope) : 0;
  const bool helps = is_integer(type) ? width <= step * float_integers : true;
  return fmt::format(
      "32-bit float rounds {} voxels by up to {:.4g}, and may make different values one{}", rounding.merged,
      rounding.largest_change,
      helps && rounding.min != 0 ? fmt::format(": ?subtract={} keeps them apart", rounding.min) : "");
}

}  // namespace crest
