#include "render/reference/trilinear_field.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "render/classify/stored_units.h"
#include "render/reference/cell_walk.h"

namespace crest::reference {
namespace {

/// The values at a cell's corners, x fastest.
struct Corners {
  float value[8];
  float low, high;
  bool is_empty;
};

Corners corners_of(const Volume& volume, glm::ivec3 cell) {
  const std::size_t row = std::size_t(volume.grid.dims.x), slice = row * std::size_t(volume.grid.dims.y);
  const float* first =
      volume.values.data() + std::size_t(cell.x) + row * std::size_t(cell.y) + slice * std::size_t(cell.z);
  Corners corners;
  for (std::size_t i = 0; i < 8; ++i)
    corners.value[i] = first[(i & 1) + (i >> 1 & 1) * row + (i >> 2) * slice];
  const auto [low, high] = std::minmax_element(corners.value, corners.value + 8);
  corners.low = *low;
  corners.high = *high;
  corners.is_empty = volume.has_empty_cells() &&
                     !std::all_of(corners.value, corners.value + 8, [](float v) { return std::isfinite(v); });
  return corners;
}

/// The field along the ray's part in a cell, less the first corner's value. One axis at a time, so that a
/// face of equal values gives exactly that value:
///   line_i(t)   = c_i + (c_{i+4} - c_i) z(t)            i = 0..3
///   square_i(t) = line_i + (line_{i+2} - line_i) y(t)   i = 0, 1
///   f(t)        = square_0 + (square_1 - square_0) x(t),   with (x, y, z) = entry + extent t.
template <class Real>
Polynomial<Real, cell_degree> field_along(const Corners& corners, const CellVisit<Real>& at) {
  Real c[8];
  for (int i = 0; i < 8; ++i) c[i] = Real(corners.value[i]) - Real(corners.value[0]);
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

/// Whether the cell was dealt with at a glance: nothing in it shows, or all of it is of one material.
template <class Real>
bool solve_plain_cell(RaySolver<Real>& solver, Real low, Real high, Real float_rounding, Real length) {
  const Levels<Real>& levels = solver.levels();
  if (levels.surface_within(low - float_rounding, high + float_rounding)) return false;
  if (solver.is_opaque() || !levels.visible_within(low, high)) {
    solver.add_clear();
    return true;
  }
  const Stretch<Real>* stretch = levels.constant_within(low, high);
  if (stretch) solver.add_constant(*stretch, length);
  return stretch != nullptr;
}

}  // namespace

template <class Real>
void solve_trilinear(RaySolver<Real>& solver, const Volume& volume, const PixelRay<Real>& ray) {
  if (!ray.inside) return;
  const glm::ivec3 dims = volume.grid.dims;
  // Positions in cells are good to a few roundings of the largest.
  const Real place_rounding =
      std::numeric_limits<Real>::epsilon() * Real(4 * std::max({dims.x, dims.y, dims.z}) + 16);
  const Real float_place_rounding = Real(ray.float_rounding.x + ray.float_rounding.y + ray.float_rounding.z);
  const Real float_base = Real(stored_units(volume.statistics.range).base);

  solver.begin_span();
  walk_cells(dims - 1, *ray.inside, [&](const CellVisit<Real>& at) {
    const Corners corners = corners_of(volume, at.cell);
    if (corners.is_empty) {
      solver.end_span();
      solver.begin_span();
      return true;
    }
    const Real low = Real(corners.low), high = Real(corners.high), range = high - low;
    // A float field value: four roundings of it as it is stored, and its change over those of the position.
    const Real float_rounding =
        Real(0x1p-22) * std::max(std::abs(low - float_base), std::abs(high - float_base)) +
        range * float_place_rounding;
    if (!solve_plain_cell(solver, low, high, float_rounding, at.length))
      solver.add(FieldPiece<Real, cell_degree>{.offset = Real(corners.value[0]),
                                               .f = field_along(corners, at),
                                               .length = at.length,
                                               .rounding = place_rounding * range,
                                               .float_rounding = float_rounding});
    return !solver.is_finished();
  });
  solver.end_span();
}

template void solve_trilinear(RaySolver<double>&, const Volume&, const PixelRay<double>&);
template void solve_trilinear(RaySolver<float>&, const Volume&, const PixelRay<float>&);

}  // namespace crest::reference
