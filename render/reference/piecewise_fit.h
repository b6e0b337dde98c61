#pragma once

#include <functional>

#include "render/reference/field_piece.h"

namespace crest::reference {

/// A piece of a function, as a polynomial.
struct FittedPiece {
  double begin = 0, length = 0;
  double offset = 0;                       ///< the function is this plus `f`
  Polynomial<double, formula_degree> f{};  ///< of (t - begin) / length
  double rounding = 0;                     ///< how far from the function it may be
};

/// Fits polynomials to `value` on [begin, begin + length], and calls visit(FittedPiece) -> whether to go on,
/// from front to back. Returns whether all were visited.
///
/// They interpolate at Chebyshev's extremal points x_i = (1 - cos(pi i / N)) / 2, i = 0..N, which include
/// both ends, so that successive pieces join. A piece is halved until it also meets the function between
/// these points: to 64 roundings of the largest value that was met in it or, if that is more, of
/// `usual_value`, the size of the terms that the function is made of. Where halving helps no more it ends:
/// where what is left is the function's own rounding, or, at a kink, at 2^-40 of the length.
bool fit_pieces(const std::function<double(double t)>& value, double begin, double length, double usual_value,
                const std::function<bool(const FittedPiece&)>& visit);

}  // namespace crest::reference
