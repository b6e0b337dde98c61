#pragma once

#include "render/reference/cell_field.h"
#include "render/reference/field_piece.h"
#include "render/volume/volume.h"

namespace crest::reference {

/// The trilinear field in a cell, from the values at its corners, x fastest. Along a ray it is a cubic.
template <class Real>
class TrilinearCell {
 public:
  TrilinearCell(const Volume& volume, glm::ivec3 cell, const Roundings<Real>& roundings)
      : roundings_(roundings) {
    const std::size_t row = std::size_t(volume.grid.dims.x), slice = row * std::size_t(volume.grid.dims.y);
    const std::size_t first = volume.index(cell.x, cell.y, cell.z);
    for (std::size_t i = 0; i < 8; ++i)
      value_[i] = volume.values[first + (i & 1) + (i >> 1 & 1) * row + (i >> 2) * slice];
    const auto [low, high] = std::minmax_element(value_, value_ + 8);
    bounds_ = make_bounds(Real(*low), Real(*high), roundings);
  }

  const CellBounds<Real>& bounds() const { return bounds_; }

  FieldPiece<Real, cell_degree> along(const CellVisit<Real>& at) const {
    return {.offset = Real(value_[0]),
            .f = polynomial(at),
            .length = at.length,
            .rounding = roundings_.place * (bounds_.high - bounds_.low),
            .float_rounding = bounds_.float_rounding};
  }

 private:
  /// Less the first corner's value. One axis at a time, so that a face of equal values gives exactly that
  /// value:
  ///   line_i(t)   = c_i + (c_{i+4} - c_i) z(t)            i = 0..3
  ///   square_i(t) = line_i + (line_{i+2} - line_i) y(t)   i = 0, 1
  ///   f(t)        = square_0 + (square_1 - square_0) x(t),   with (x, y, z) = entry + extent t.
  Polynomial<Real, cell_degree> polynomial(const CellVisit<Real>& at) const {
    Real c[8];
    for (int i = 0; i < 8; ++i) c[i] = Real(value_[i]) - Real(value_[0]);
    Polynomial<Real, 1> line[4];
    for (int i = 0; i < 4; ++i) {
      const Real step = c[i + 4] - c[i];
      line[i].c = {c[i] + step * at.entry.z, step * at.extent.z};
    }
    Polynomial<Real, 2> square[2];
    for (int i = 0; i < 2; ++i) {
      const auto &a = line[i].c, &b = line[i + 2].c;
      const Real step = b[0] - a[0], tilt = b[1] - a[1];
      square[i].c = {a[0] + step * at.entry.y, a[1] + tilt * at.entry.y + step * at.extent.y,
                     tilt * at.extent.y};
    }
    const auto &a = square[0].c, &b = square[1].c;
    const Real step = b[0] - a[0], tilt = b[1] - a[1], bend = b[2] - a[2];
    return {{a[0] + step * at.entry.x, a[1] + tilt * at.entry.x + step * at.extent.x,
             a[2] + bend * at.entry.x + tilt * at.extent.x, bend * at.extent.x}};
  }

  Roundings<Real> roundings_;
  float value_[8];
  CellBounds<Real> bounds_;
};

}  // namespace crest::reference
