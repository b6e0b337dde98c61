#include "render/reference/piecewise_fit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

namespace crest::reference {
namespace {

constexpr int degree = formula_degree;
constexpr int most_halvings = 40;
constexpr double roundings = 64 * std::numeric_limits<double>::epsilon();
constexpr double most_noise = 1000;  // times the rounding that is asked for

/// Interpolation at Chebyshev's extremal points, which include both ends.
struct Interpolation {
  std::array<double, degree + 1> node;
  std::array<Polynomial<double, degree>, degree + 1> lagrange;  ///< 1 at its node, 0 at the others
};

Interpolation make_interpolation() {
  Interpolation result;
  for (int i = 0; i <= degree; ++i)
    result.node[std::size_t(i)] = (1 - std::cos(std::numbers::pi * i / degree)) / 2;
  for (std::size_t i = 0; i <= degree; ++i) {
    std::array<long double, degree + 1> product{1};
    for (std::size_t j = 0, size = 0; j <= degree; ++j) {
      if (j == i) continue;
      const long double x = result.node[j], scale = 1 / (static_cast<long double>(result.node[i]) - x);
      ++size;
      for (std::size_t k = size + 1; k-- > 0;)
        product[k] = ((k > 0 ? product[k - 1] : 0) - x * product[k]) * scale;
    }
    std::transform(product.begin(), product.end(), result.lagrange[i].c.begin(),
                   [](long double c) { return double(c); });
  }
  return result;
}

const Interpolation& interpolation() {
  static const Interpolation result = make_interpolation();
  return result;
}

using Function = std::function<double(double)>;

/// The polynomial through the function's values on `whole`, with its rounding.
FittedPiece interpolate(const Function& value, const FittedPiece& whole) {
  const Interpolation& rule = interpolation();
  FittedPiece piece = whole;
  piece.offset = value(piece.begin);
  piece.f = {};
  double largest = std::abs(piece.offset);
  for (std::size_t i = 1; i <= degree; ++i) {
    const double at_node = value(piece.begin + rule.node[i] * piece.length);
    largest = std::max(largest, std::abs(at_node));
    for (std::size_t k = 0; k <= degree; ++k)
      piece.f.c[k] += (at_node - piece.offset) * rule.lagrange[i].c[k];
  }
  piece.rounding = std::max(whole.rounding, roundings * largest);
  return piece;
}

/// How far the piece is from the function between the points of interpolation.
double distance(const Function& value, const FittedPiece& piece) {
  const Interpolation& rule = interpolation();
  double most = 0;
  for (std::size_t i = 0; i < degree; ++i) {
    const double x = std::midpoint(rule.node[i], rule.node[i + 1]);
    const double off = piece.offset + piece.f(x) - value(piece.begin + x * piece.length);
    most = std::max(most, std::abs(off));
  }
  return most;
}

/// `off_before` is how far the piece that this one is half of was from the function.
bool fit(const Function& value, const FittedPiece& whole, double off_before, int halvings,
         const std::function<bool(const FittedPiece&)>& visit) {
  FittedPiece piece = interpolate(value, whole);
  const double off = distance(value, piece);
  // A small distance that halving leaves as it is is the rounding of the formula itself.
  const bool is_noise = off < most_noise * piece.rounding && off > off_before / 4;
  if (off <= piece.rounding || is_noise || halvings == most_halvings) {
    piece.rounding = std::max(piece.rounding, 2 * off);
    return visit(piece);
  }
  FittedPiece half{.begin = piece.begin, .length = piece.length / 2, .rounding = piece.rounding};
  if (!fit(value, half, off, halvings + 1, visit)) return false;
  half.begin += half.length;
  half.length = piece.begin + piece.length - half.begin;
  return fit(value, half, off, halvings + 1, visit);
}

}  // namespace

bool fit_pieces(const Function& value, double begin, double length, double usual_value,
                const std::function<bool(const FittedPiece&)>& visit) {
  return fit(value, {.begin = begin, .length = length, .rounding = roundings * usual_value},
             std::numeric_limits<double>::infinity(), 0, visit);
}

}  // namespace crest::reference
