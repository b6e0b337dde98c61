#pragma once

#include "render/reference/pixel_ray.h"
#include "render/reference/ray_solver.h"
#include "render/volume/builtin.h"

namespace crest::reference {

/// Gives the solver a formula over a grid's box along the ray, in pieces from the front, as long as anything
/// more may show or be crossed. `usual_value` is the size of its values.
void solve_formula(RaySolver<double>& solver, const FormulaField& field, const Grid& grid, double usual_value,
                   const PixelRay<double>& ray);

}  // namespace crest::reference
