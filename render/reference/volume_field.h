#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "render/reference/pixel_ray.h"
#include "render/reference/ray_solver.h"
#include "render/volume/filter.h"
#include "render/volume/volume.h"

namespace crest::reference {

/// For each cell of a volume, x fastest, whether it is empty for filters of this radius (find_empty_cells).
struct EmptyCells {
  const Volume* volume;  ///< whose they are; not looked into
  int radius;
  std::vector<std::uint8_t> cells;
};

/// A volume's field, or two: of one filter what is integrated, of the other that in which surfaces lie.
struct VolumeFields {
  const Volume& volume;
  FieldFilter dvr, root;
  std::shared_ptr<const EmptyCells> empty_cells;  ///< null: none is
};

/// What is solved along a ray: the TF, and the surfaces among its levels; or, where these lie in another
/// field, the TF alone, and the surfaces alone.
template <class Real>
struct FieldLevels {
  Levels<Real> levels;
  Levels<Real> surfaces;  ///< where the fields differ
  bool are_apart = false;
};

/// Gives the solver the field along the ray, cell by cell from the front, as long as anything more may show
/// or be crossed. An empty cell ends a span; cells in which nothing shows or changes are not solved. With two
/// fields the surfaces are solved in theirs, and the piece of the other is cut where they are met.
template <class Real>
void solve_volume(RaySolver<Real>& solver, const VolumeFields& fields, const FieldLevels<Real>& levels,
                  double tolerance, const PixelRay<Real>& ray);

/// A place on a ray that is traced.
struct TracedPlace {
  double length = 0;                                ///< from where the ray enters, in smallest spacings
  double value = 0;                                 ///< of the field that is integrated; NaN in an empty cell
  const CrossedSurface<double>* crossed = nullptr;  ///< the surface that was composited here, if it was
};

/// The same, to the ray's end, and told as it goes: each cell is solved in `parts_a_cell` parts and cut where
/// surfaces are met; visit(place) is called at the entry, behind each part and behind each surface, when the
/// solver has collected all before it. `levels.are_apart`.
void trace_volume(RaySolver<double>& solver, const VolumeFields& fields, const FieldLevels<double>& levels,
                  double tolerance, const PixelRay<double>& ray, int parts_a_cell,
                  const std::function<void(const TracedPlace&)>& visit);

}  // namespace crest::reference
