#pragma once

#include "render/reference/pixel_ray.h"
#include "render/reference/ray_solver.h"
#include "render/volume/volume.h"

namespace crest::reference {

/// Gives the solver the trilinear field along the ray, cell by cell from the front, as long as anything more
/// may show or be crossed. A cell with a NaN or Inf corner ends a span; cells in which nothing shows or
/// changes are not solved.
template <class Real>
void solve_trilinear(RaySolver<Real>& solver, const Volume& volume, const PixelRay<Real>& ray);

}  // namespace crest::reference
