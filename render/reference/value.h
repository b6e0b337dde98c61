#pragma once

#include <glm/vec3.hpp>

namespace crest::reference {

template <class Real>
using Vec3 = glm::vec<3, Real>;

/// A number as the unevaluated sum of two: a field's value at a large offset, or a place in a TF that is
/// narrower than the rounding of its value. Differences of near values keep their digits.
template <class Real>
struct Value {
  Real hi = 0, lo = 0;
};

/// a + b without rounding (Knuth's two-sum).
template <class Real>
Value<Real> exact_sum(Real a, Real b) {
  const Real sum = a + b, rest = sum - a;
  return {sum, (a - (sum - rest)) + (b - rest)};
}

template <class Real>
Real operator-(Value<Real> a, Value<Real> b) {
  return (a.hi - b.hi) + (a.lo - b.lo);
}

}  // namespace crest::reference
