#pragma once

#include <type_traits>

namespace crest {

/// What stored values are multiplied by, and what is added.
struct LinearMap {
  double slope = 1, intercept = 0;
  bool operator==(const LinearMap&) const = default;
};

/// A stored value mapped in a type that holds it exactly: 64-bit integers have more digits than double.
template <class T>
auto mapped(T value, LinearMap map) {
  using Wide = std::conditional_t<std::is_integral_v<T> && sizeof(T) == 8, long double, double>;
  return static_cast<Wide>(value) * static_cast<Wide>(map.slope) + static_cast<Wide>(map.intercept);
}

/// The volume's value: mapped exactly, and rounded once.
template <class T>
float mapped_to_float(T value, LinearMap map) {
  return map == LinearMap() ? float(value) : float(mapped(value, map));
}

}  // namespace crest
