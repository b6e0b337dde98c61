#pragma once

#include <cstdint>
#include <vector>

#include "render/reference/pixel_ray.h"
#include "render/reference/ray_solver.h"
#include "render/volume/filter.h"
#include "render/volume/volume.h"

namespace crest::reference {

/// A volume's field, or two: of one filter what is integrated, of the other that in which surfaces lie.
struct VolumeFields {
  const Volume& volume;
  FieldFilter dvr, root;
  /// For each cell, x fastest, whether it is empty: with a filter of radius 2 more are than those with a
  /// corner without a value (find_empty_cells). Without an entry, none is.
  std::vector<std::uint8_t> empty_cells;
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

}  // namespace crest::reference
