#include "render/reference/volume_field.h"

#include <limits>
#include <utility>

#include "render/reference/cubic_cell.h"
#include "render/reference/trilinear_cell.h"

namespace crest::reference {
namespace {

/// Calls visit(CellVisit, is_empty) -> whether to go on for each cell that the ray is in.
template <class Real, class Visit>
void visit_cells(const VolumeFields& fields, const PixelRay<Real>& ray, Visit&& visit) {
  const glm::ivec3 cells = fields.volume.grid.dims - 1;
  walk_cells(cells, *ray.inside, [&](const CellVisit<Real>& at) {
    const std::size_t index =
        std::size_t(at.cell.x) +
        std::size_t(cells.x) * (std::size_t(at.cell.y) + std::size_t(cells.y) * std::size_t(at.cell.z));
    return visit(at, fields.empty_cells && fields.empty_cells->cells[index] != 0);
  });
}

/// Calls use(make_cell) with a function that makes the filter's cells, of either kind.
template <class Real, class Use>
void with_cells(const Volume& volume, const FieldFilter& filter, const PixelRay<Real>& ray, Use&& use) {
  const auto roundings = roundings_of(volume, ray);
  if (radius_of(filter) == 1) {
    use([&](glm::ivec3 cell) { return TrilinearCell<Real>(volume, cell, roundings); });
  } else {
    const CubicFilter<Real> cubic = make_cubic_filter<Real>(filter);
    use([&](glm::ivec3 cell) { return CubicCell<Real>(volume, cubic, cell, roundings); });
  }
}

/// Whether the cell was dealt with at a glance: nothing in it shows, or all of it is of one material.
template <class Real>
bool solve_plain_cell(RaySolver<Real>& solver, const CellBounds<Real>& bounds, Real length) {
  const Levels<Real>& levels = solver.levels();
  if (levels.surface_within(bounds.low - bounds.float_rounding, bounds.high + bounds.float_rounding))
    return false;
  if (solver.is_opaque() || !levels.visible_within(bounds.low, bounds.high)) {
    solver.add_clear();
    return true;
  }
  const LinearPiece<Real>* linear = levels.constant_within(bounds.low, bounds.high);
  if (linear) solver.add_constant(*linear, length);
  return linear != nullptr;
}

template <class Real>
void restart(RaySolver<Real>& solver) {
  solver.end_span();
  solver.begin_span();
}

template <class Real, class MakeCell>
void solve_one_field(RaySolver<Real>& solver, const VolumeFields& fields, const MakeCell& make_cell,
                     const PixelRay<Real>& ray) {
  solver.begin_span();
  visit_cells(fields, ray, [&](const CellVisit<Real>& at, bool is_empty) {
    if (is_empty) {
      restart(solver);
      return true;
    }
    const auto cell = make_cell(at.cell);
    if (!solve_plain_cell(solver, cell.bounds(), at.length)) solver.add(cell.along(at));
    return !solver.is_finished();
  });
  solver.end_span();
}

/// The part of a piece between two places of it.
template <class Real, int N>
FieldPiece<Real, N> part_of(FieldPiece<Real, N> piece, Real from, Real to) {
  piece.f = piece.f.shifted(from).stretched(to - from);
  piece.length *= to - from;
  return piece;
}

/// The integral over a cell, with the surfaces that are met in it in between.
template <class Real, class Cell>
void solve_around(RaySolver<Real>& solver, const Cell& cell, const CellVisit<Real>& at,
                  const std::vector<MetSurface<Real>>& met) {
  Real from = 0;
  const auto integrate_to = [&](Real to) {
    if (to > from && !solve_plain_cell(solver, cell.bounds(), (to - from) * at.length))
      solver.add(part_of(cell.along(at), from, to));
    from = std::max(from, to);
  };
  for (const MetSurface<Real>& surface : met) {
    integrate_to(surface.place);
    solver.composite_surface(*surface.surface);
  }
  integrate_to(Real(1));
}

template <class Real, class MakeCell, class MakeRootCell>
void solve_two_fields(RaySolver<Real>& solver, RaySolver<Real>& roots, std::vector<MetSurface<Real>>& met,
                      const VolumeFields& fields, const MakeCell& make_cell,
                      const MakeRootCell& make_root_cell, const PixelRay<Real>& ray) {
  solver.begin_span();
  roots.begin_span();
  visit_cells(fields, ray, [&](const CellVisit<Real>& at, bool is_empty) {
    if (is_empty) {
      restart(solver);
      restart(roots);
      return true;
    }
    met.clear();
    const auto root_cell = make_root_cell(at.cell);
    if (!solve_plain_cell(roots, root_cell.bounds(), at.length)) roots.add(root_cell.along(at));
    if (solver.is_opaque() && met.empty())
      solver.add_clear();
    else
      solve_around(solver, make_cell(at.cell), at, met);
    return true;
  });
  solver.end_span();
  roots.end_span();
  if (roots.collected().grazing) solver.note_grazing();
}

/// What a trace of one ray carries from cell to cell.
struct Trace {
  RaySolver<double>&solver, &roots;
  std::vector<MetSurface<double>>& met;
  int parts_a_cell;
  const std::function<void(const TracedPlace&)>& visit;
  double length = 0;  ///< before the cell
};

template <class Cell>
void trace_cell(Trace& trace, const Cell& cell, const CellVisit<double>& at) {
  const auto piece = cell.along(at);
  double from = 0;
  const auto place = [&](double where, const CrossedSurface<double>* crossed) {
    trace.visit({trace.length + where * at.length, piece.offset + piece.f(where), crossed});
  };
  const auto integrate_to = [&](double to) {
    if (!(to > from)) return;
    if (!solve_plain_cell(trace.solver, cell.bounds(), (to - from) * at.length))
      trace.solver.add(part_of(piece, from, to));
    from = to;
    place(to, nullptr);
  };
  auto next = trace.met.begin();
  for (int part = 1; part <= trace.parts_a_cell; ++part) {
    const double to = part == trace.parts_a_cell ? 1 : double(part) / trace.parts_a_cell;
    for (; next != trace.met.end() && next->place <= to; ++next) {
      integrate_to(next->place);
      trace.solver.composite_surface(*next->surface);
      place(next->place, next->surface);
    }
    integrate_to(to);
  }
  trace.length += at.length;
}

}  // namespace

void trace_volume(RaySolver<double>& solver, const VolumeFields& fields, const FieldLevels<double>& levels,
                  double tolerance, const PixelRay<double>& ray, int parts_a_cell,
                  const std::function<void(const TracedPlace&)>& visit) {
  if (!ray.inside) return;
  std::vector<MetSurface<double>> met;
  RaySolver<double> roots(levels.surfaces, tolerance);
  roots.tell_surfaces(met);
  Trace trace{solver, roots, met, parts_a_cell, visit};
  with_cells(fields.volume, fields.dvr, ray, [&](const auto& make_cell) {
    with_cells(fields.volume, fields.root, ray, [&](const auto& make_root_cell) {
      solver.begin_span();
      roots.begin_span();
      bool begins = true;
      visit_cells(fields, ray, [&](const CellVisit<double>& at, bool is_empty) {
        if (is_empty) {
          restart(solver);
          restart(roots);
          visit({trace.length, std::numeric_limits<double>::quiet_NaN(), nullptr});
          trace.length += at.length;
          begins = true;
          return true;
        }
        met.clear();
        const auto root_cell = make_root_cell(at.cell);
        if (!solve_plain_cell(roots, root_cell.bounds(), at.length)) roots.add(root_cell.along(at));
        const auto cell = make_cell(at.cell);
        if (std::exchange(begins, false)) {
          const auto piece = cell.along(at);
          visit({trace.length, piece.offset + piece.f(0), nullptr});
        }
        trace_cell(trace, cell, at);
        return true;
      });
      solver.end_span();
      roots.end_span();
    });
  });
}

template <class Real>
void solve_volume(RaySolver<Real>& solver, const VolumeFields& fields, const FieldLevels<Real>& levels,
                  double tolerance, const PixelRay<Real>& ray) {
  if (!ray.inside) return;
  with_cells(fields.volume, fields.dvr, ray, [&](const auto& make_cell) {
    if (!levels.are_apart) return solve_one_field(solver, fields, make_cell, ray);
    std::vector<MetSurface<Real>> met;
    RaySolver<Real> roots(levels.surfaces, tolerance);
    roots.tell_surfaces(met);
    with_cells(fields.volume, fields.root, ray, [&](const auto& make_root_cell) {
      solve_two_fields(solver, roots, met, fields, make_cell, make_root_cell, ray);
    });
  });
}

template void solve_volume(RaySolver<double>&, const VolumeFields&, const FieldLevels<double>&, double,
                           const PixelRay<double>&);
template void solve_volume(RaySolver<float>&, const VolumeFields&, const FieldLevels<float>&, double,
                           const PixelRay<float>&);

}  // namespace crest::reference
