#include "render/volume/filter_bounds.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace crest {
namespace {

double value_at(const CubicWeight& p, double u) { return p[0] + u * (p[1] + u * (p[2] + u * p[3])); }

/// The largest value of a cubic on [0, 1]: at an end, or where its derivative vanishes.
double largest(const CubicWeight& p) {
  double most = std::max(value_at(p, 0), value_at(p, 1));
  const double a = 3 * p[3], half_b = p[2], c = p[1], discriminant = half_b * half_b - a * c;
  if (discriminant < 0) return most;
  const double q = -(half_b + std::copysign(std::sqrt(discriminant), half_b));
  for (const double u : {q / a, c / q})
    if (u > 0 && u < 1) most = std::max(most, value_at(p, u));
  return most;
}

/// max over u in [0, 1] of sum |p_i(u)|, which is the largest that any choice of signs gives.
double largest_sum(std::span<const CubicWeight> p) {
  double most = 0;
  for (unsigned signs = 0; signs < 1u << p.size(); ++signs) {
    CubicWeight sum{};
    for (std::size_t i = 0; i < p.size(); ++i)
      for (std::size_t k = 0; k < 4; ++k) sum[k] += (signs >> i & 1) ? -p[i][k] : p[i][k];
    most = std::max(most, largest(sum));
  }
  return most;
}

}  // namespace

FilterBounds filter_bounds(const FieldFilter& filter) {
  FilterBounds bounds{.radius = radius_of(filter)};
  switch (filter.kind) {
    case Filter::linear:
    case Filter::linear_exact:
    case Filter::bspline:
      return bounds;  // no weight is negative
    case Filter::bc:
      break;
  }
  const auto weights = filter_weights(filter);
  std::array<CubicWeight, 3> differences{};  // D_j: of v_{j+1} - v_j
  for (std::size_t j = 0; j < 3; ++j)
    for (std::size_t i = j + 1; i < 4; ++i)
      for (std::size_t k = 0; k < 3; ++k) differences[j][k] += double(k + 1) * weights[i][k + 1];
  const double sum = std::max(largest_sum(weights), 1.0);
  bounds.overshoot = (sum * sum * sum - 1) / 2;
  bounds.steepness = largest_sum(differences) * sum * sum;
  return bounds;
}

ValueRange field_range(const FieldFilter& filter, ValueRange points) {
  const double beyond = filter_bounds(filter).overshoot * points.width();
  return {points.min - beyond, points.max + beyond};
}

}  // namespace crest
