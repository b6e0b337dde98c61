#pragma once

#include "render/reference/polynomial.h"

namespace crest::reference {

/// Degrees of the polynomials that the field along a ray is: in a cell of a trilinear field and of a cubic
/// filter's exactly; of a formula to its rounding, in pieces as short as that takes.
inline constexpr int cell_degree = 3, cubic_cell_degree = 9, formula_degree = 8;

/// The field along a piece of a ray.
template <class Real, int N>
struct FieldPiece {
  Real offset = 0;          ///< the field is this plus `f`
  Polynomial<Real, N> f;    ///< of a place in [0, 1]
  Real length = 0;          ///< in smallest spacings
  Real rounding = 0;        ///< of f's values: those nearer to each other count as equal
  Real float_rounding = 0;  ///< of the field, where positions and values are rounded to 32-bit float
};

}  // namespace crest::reference
