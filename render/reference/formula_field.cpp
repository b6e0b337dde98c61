#include "render/reference/formula_field.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "render/reference/piecewise_fit.h"

namespace crest::reference {
namespace {

constexpr int fewest_pieces = 8;

}  // namespace

void solve_formula(RaySolver<double>& solver, const FormulaField& field, const Grid& grid, double usual_value,
                   const PixelRay<double>& ray) {
  if (!ray.inside) return;
  const CellRay<double>& inside = *ray.inside;
  const auto position = [&](double t) {
    return grid.origin + grid.spacing * (inside.origin + t * inside.direction);
  };
  const auto add = [&](const FittedPiece& piece) {
    const glm::dvec3 slope = field.gradient(position(piece.begin + piece.length / 2)) * grid.spacing;
    const double float_rounding = 0x1p-22 * std::max(usual_value, std::abs(piece.offset)) +
                                  glm::dot(glm::abs(slope), ray.float_rounding);
    solver.add(FieldPiece<double, formula_degree>{.offset = piece.offset,
                                                  .f = piece.f,
                                                  .length = piece.length,
                                                  .rounding = piece.rounding,
                                                  .float_rounding = float_rounding});
    return !solver.is_finished();
  };
  // Begun with pieces no longer than a cell, lest a thin feature falls between the points of the first fit
  const int count = std::max(fewest_pieces, int(std::ceil(inside.length)));
  solver.begin_span();
  for (int i = 0; i < count; ++i) {
    const double begin = inside.length * i / count, end = inside.length * (i + 1) / count;
    if (!fit_pieces([&](double t) { return field.value(position(t)); }, begin, end - begin, usual_value, add))
      break;
  }
  solver.end_span();
}

}  // namespace crest::reference
