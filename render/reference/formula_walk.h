#pragma once

#include <functional>

#include "render/reference/field_degrees.h"
#include "render/reference/polynomial.h"

namespace crest::reference {

/// A piece of a function of the ray's parameter, as a polynomial.
struct FittedPiece {
  double begin = 0, length = 0;
  double offset = 0;                       ///< the function is this plus `f`
  Polynomial<double, formula_degree> f{};  ///< of (t - begin) / length
  double rounding = 0;                     ///< how far from the function it may be
};

/// Fits polynomials to `value` on [begin, begin + length], and calls visit(FittedPiece) -> whether to go on,
/// from front to back. They interpolate at Chebyshev's points; a piece is halved until it meets the function
/// to `rounding` between them too, or, at a kink, has 2^-40 of the length. Returns whether all were visited.
bool fit_pieces(const std::function<double(double t)>& value, double begin, double length, double rounding,
                const std::function<bool(const FittedPiece&)>& visit);

}  // namespace crest::reference
