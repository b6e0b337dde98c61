#pragma once

#include <array>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/special_functions/legendre.hpp>
#include <cstddef>

namespace crest::reference {

/// Gauss-Legendre quadrature on [0, 1] that also gives the running integral at its own nodes x_i:
///
///   integral from 0 to 1 of g = sum_j weight_j g(x_j),   from 0 to x_i = sum_j up_to_node_ij g(x_j),
///
/// so that the integral of rho(x) exp(-integral of rho up to x) takes one value of rho a node.
template <class Real, int N>
struct Collocation {
  std::array<Real, N> node, weight;
  std::array<std::array<Real, N>, N>
      up_to_node;  ///< [i][j]: weight of the value at j in the integral up to i
};

/// up_to_node_ij is the integral of the Lagrange polynomial of node j. On [-1, 1], by its Legendre series,
///
///   w_j / 2 * sum over k of (2k + 1) P_k(x_j) * integral from -1 to x_i of P_k,   where the last is
///   (P_{k+1}(x_i) - P_{k-1}(x_i)) / (2k + 1), and x_i + 1 for k = 0.
template <class Real, int N>
Collocation<Real, N> make_collocation() {
  using Rule = boost::math::quadrature::gauss<double, N>;
  using boost::math::legendre_p;
  std::array<double, N> x{}, w{};
  const auto& abscissa = Rule::abscissa();  // those that are not negative, ascending
  for (std::size_t i = 0; i < abscissa.size(); ++i) {
    const std::size_t high = N / 2 + i, low = N - 1 - high;
    x[high] = abscissa[i];
    x[low] = -abscissa[i];
    w[high] = w[low] = Rule::weights()[i];
  }
  Collocation<Real, N> rule{};
  for (std::size_t i = 0; i < N; ++i) {
    rule.node[i] = Real((x[i] + 1) / 2);
    rule.weight[i] = Real(w[i] / 2);
    for (std::size_t j = 0; j < N; ++j) {
      double sum = x[i] + 1;
      for (int k = 1; k < N; ++k)
        sum += legendre_p(k, x[j]) * (legendre_p(k + 1, x[i]) - legendre_p(k - 1, x[i]));
      rule.up_to_node[i][j] = Real(sum * w[j] / 4);
    }
  }
  return rule;
}

template <class Real, int N>
const Collocation<Real, N>& collocation() {
  static const Collocation<Real, N> rule = make_collocation<Real, N>();
  return rule;
}

}  // namespace crest::reference
