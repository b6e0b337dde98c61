#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace crest::reference {

/// p(x) = c[0] + c[1] x + ... + c[N] x^N, used on [0, 1].
template <class Real, int N>
struct Polynomial {
  std::array<Real, N + 1> c{};

  Real operator()(Real x) const {
    Real sum = c[N];
    for (std::size_t k = N; k-- > 0;) sum = sum * x + c[k];
    return sum;
  }

  Polynomial<Real, N - 1> derivative() const {
    Polynomial<Real, N - 1> d;
    for (std::size_t k = 0; k < N; ++k) d.c[k] = Real(k + 1) * c[k + 1];
    return d;
  }

  /// The same polynomial as a function of x - x0. Near x0 its differences from c[0] keep their digits.
  Polynomial shifted(Real x0) const {
    Polynomial s = *this;
    for (std::size_t i = 0; i < N; ++i)
      for (std::size_t k = N; k-- > i;) s.c[k] += x0 * s.c[k + 1];
    return s;
  }

  /// That of `factor * x`.
  Polynomial stretched(Real factor) const {
    Polynomial s = *this;
    Real power = 1;
    for (Real& coefficient : s.c) {
      coefficient *= power;
      power *= factor;
    }
    return s;
  }
};

/// Places in [0, 1], ascending.
template <class Real, int N>
struct Places {
  std::array<Real, N> at{};
  int count = 0;
};

/// Where p, which is monotone on [low, high] and rises or falls there, has the value `target`: Newton's
/// method within a bracket that bisection keeps. `low` or `high` where the value lies beyond. (Boost 1.74's
/// newton_raphson_iterate throws where rounding hides the change of sign.)
template <class Real, int N>
Real solve_monotone(const Polynomial<Real, N>& p, Real target, Real low, Real high, bool rising, Real guess) {
  constexpr Real eps = std::numeric_limits<Real>::epsilon();
  Real x = guess > low && guess < high ? guess : (low + high) / 2;
  for (int i = 0; i < 128; ++i) {
    Real value = p.c[N], slope = 0;
    for (std::size_t k = N; k-- > 0;) {
      slope = slope * x + value;
      value = value * x + p.c[k];
    }
    value -= target;
    if (value == 0) return x;
    if ((value < 0) == rising)
      low = x;
    else
      high = x;
    Real next = x - value / slope;
    if (!(next > low && next < high)) next = low + (high - low) / 2;
    if (std::abs(next - x) <= eps * std::abs(next)) return next;
    x = next;
  }
  return x;
}

/// Whether Bernstein's coefficients on [0, 1], b_i = sum over k <= i of c_k (i over k) / (N over k), have one
/// sign, so that p has no root there.
template <class Real, int N>
bool has_one_sign(const Polynomial<Real, N>& p) {
  bool above = false, below = false;
  for (int i = 0; i <= N; ++i) {
    Real sum = 0, ratio = 1;  // of the binomials (i, k) / (N, k)
    for (int k = 0; k <= i; ++k) {
      sum += ratio * p.c[std::size_t(k)];
      if (k < i) ratio *= Real(i - k) / Real(N - k);
    }
    above = above || sum > 0;
    below = below || sum < 0;
  }
  return !(above && below);
}

/// Where p changes its sign within (0, 1). Between the extrema, which are where its derivative does, there is
/// one root at most.
template <class Real, int N>
Places<Real, N> sign_changes(const Polynomial<Real, N>& p) {
  Places<Real, N> found;
  if (has_one_sign(p)) return found;
  if constexpr (N == 1) {
    found.at[found.count++] = -p.c[0] / p.c[1];
  } else {
    const Places<Real, N - 1> extrema = sign_changes(p.derivative());
    Real low = 0, at_low = p.c[0];
    for (int i = 0; i <= extrema.count; ++i) {
      const Real high = i < extrema.count ? extrema.at[std::size_t(i)] : Real(1), at_high = p(high);
      if ((at_low > 0) != (at_high > 0)) {
        const Real guess = low + (high - low) * (at_low / (at_low - at_high));
        found.at[std::size_t(found.count++)] = solve_monotone(p, Real(0), low, high, at_high > 0, guess);
      }
      low = high;
      at_low = at_high;
    }
  }
  return found;
}

}  // namespace crest::reference
