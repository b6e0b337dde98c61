#pragma once

#include <span>

#include "render/reference/cell_field.h"
#include "render/reference/field_piece.h"
#include "render/volume/filter_bounds.h"
#include "render/volume/volume.h"

namespace crest::reference {

/// What cubic cells of one filter have in common.
template <class Real>
struct CubicFilter {
  std::array<Polynomial<Real, 3>, 4> weight;  ///< of points i-1 .. i+2 at a place from 0 to 1 in the cell
  Real overshoot = 0;
};

template <class Real>
CubicFilter<Real> make_cubic_filter(const FieldFilter& filter) {
  CubicFilter<Real> result;
  result.overshoot = Real(filter_bounds(filter).overshoot);
  const auto weights = filter_weights(filter);
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t k = 0; k < 4; ++k) result.weight[i].c[k] = Real(weights[i][k]);
  return result;
}

/// The field of a cubic filter in a cell, from the 64 points around it; those beyond the grid's ends are its
/// end points. Along a ray each axis' weights are cubics, and the field is their product: of degree 9.
template <class Real>
class CubicCell {
 public:
  CubicCell(const Volume& volume, const CubicFilter<Real>& filter, glm::ivec3 cell,
            const Roundings<Real>& roundings)
      : filter_(filter), roundings_(roundings) {
    const glm::ivec3 last = volume.grid.dims - 1;
    float* next = value_;
    for (int k = -1; k <= 2; ++k)
      for (int j = -1; j <= 2; ++j)
        for (int i = -1; i <= 2; ++i)
          *next++ = volume.at(std::clamp(cell.x + i, 0, last.x), std::clamp(cell.y + j, 0, last.y),
                              std::clamp(cell.z + k, 0, last.z));
    const auto [low, high] = std::minmax_element(value_, value_ + 64);
    const Real beyond = filter.overshoot * (Real(*high) - Real(*low));
    bounds_ = make_bounds(Real(*low) - beyond, Real(*high) + beyond, roundings);
  }

  const CellBounds<Real>& bounds() const { return bounds_; }

  FieldPiece<Real, cubic_cell_degree> along(const CellVisit<Real>& at) const {
    return {.offset = Real(offset()),
            .f = polynomial(at),
            .length = at.length,
            .rounding = roundings_.place * (bounds_.high - bounds_.low),
            .float_rounding = bounds_.float_rounding};
  }

 private:
  using Weights = std::array<Polynomial<Real, 3>, 4>;

  float offset() const { return value_[1 + 4 * 1 + 16 * 1]; }  // the cell's first corner

  /// The weights on an axis, as polynomials of the place along the ray's part in the cell.
  Weights weights_along(Real entry, Real extent) const {
    Weights along;
    for (std::size_t i = 0; i < 4; ++i) along[i] = filter_.weight[i].shifted(entry).stretched(extent);
    return along;
  }

  /// sum of w_i f_i, as f_1 + sum of w_i (f_i - f_1), since the weights sum to 1: where all are equal it is
  /// exactly that.
  template <int N>
  static Polynomial<Real, N + 3> weighted(const Weights& w, const std::array<Polynomial<Real, N>, 4>& f) {
    Polynomial<Real, N + 3> sum;
    std::copy(f[1].c.begin(), f[1].c.end(), sum.c.begin());
    for (const std::size_t i : {0, 2, 3})
      for (std::size_t n = 0; n <= N; ++n)
        for (std::size_t k = 0; k <= 3; ++k) sum.c[n + k] += w[i].c[k] * (f[i].c[n] - f[1].c[n]);
    return sum;
  }

  Polynomial<Real, cubic_cell_degree> polynomial(const CellVisit<Real>& at) const {
    const Weights x = weights_along(at.entry.x, at.extent.x), y = weights_along(at.entry.y, at.extent.y),
                  z = weights_along(at.entry.z, at.extent.z);
    std::array<Polynomial<Real, 6>, 4> slices;
    const float* next = value_;
    for (auto& slice : slices) {
      std::array<Polynomial<Real, 3>, 4> rows;
      for (auto& row : rows) {
        std::array<Polynomial<Real, 0>, 4> points;
        for (auto& point : points) point.c = {Real(*next++) - Real(offset())};
        row = weighted(x, points);
      }
      slice = weighted(y, rows);
    }
    return weighted(z, slices);
  }

  const CubicFilter<Real>& filter_;
  Roundings<Real> roundings_;
  float value_[64];
  CellBounds<Real> bounds_;
};

}  // namespace crest::reference
