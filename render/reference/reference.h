#pragma once

#include <cstdint>
#include <functional>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <vector>

#include "render/files/image.h"
#include "render/reference/answer.h"
#include "render/scene/scene.h"
#include "render/volume/builtin.h"

namespace crest {

/// Told the share that is done, in [0, 1], from any thread, one call at a time; false = stop.
using Progress = std::function<bool(double done)>;

/// Thrown when a Progress asked for a stop.
struct Cancelled {};

/// The exact picture.
struct Reference {
  glm::ivec2 size{0};
  std::vector<glm::dvec4> pixels;        ///< premultiplied RGBA, row 0 at the top
  std::vector<std::uint32_t> crossings;  ///< of the surfaces that the answer shows, by the pixel's ray
  /// 1 where the ray passes a surface's tangent, or a surface at the ray's end, within the rounding of 32-bit
  /// float: there a renderer in float may rightly count a crossing more or less. Such pixels are compared
  /// apart.
  std::vector<std::uint8_t> grazing;

  Image image() const;  ///< rounded to float
};

inline constexpr double default_tolerance = 1e-10;

/// Solves every pixel's ray to `tolerance` (absolute, in each channel), on all cores. Step, placement,
/// shading and early termination have no part in it; the clip box has. Throws Error, Cancelled.
///
/// What is solved is, on a ray x(s) from the eye on, with the field f(s) = f(x(s)) of `rendering.filter` in
/// the box (where `root_filter` is another, the crossings are those of its field),
///
///   I = integral of c(f(s)) rho(f(s)) T(s) ds,   rho = -ln(max(1 - a(f), 2^-24)) / unit_distance,
///   T(s) = exp(-integral of rho up to s) * product of (1 - a_k) over the crossings k before s,
///
/// plus T(s_k) c_k a_k at each crossing s_k, of which an answer may leave out either (answer.h). The way
/// there:
///
///   pixel_ray        a pixel's ray, where it is in the rendered box
///   cell_walk        the cells on it; in a cell f(s) is a polynomial, of degree 3 (trilinear_cell) or, with
///                    cubic filters, 9 (cubic_cell); one field or two, cell by cell (volume_field)
///   piecewise_fit    or f(s) of a formula, as polynomials (formula_field)
///   levels           the TF, cut at the values where it bends, where the cap begins, and of the surfaces
///   ray_solver       f(s) cut at its extrema and where it meets a level: in between all is smooth
///   ramp             the integral over one such piece, by the rule of collocation.h
///   polynomial       roots, one between each two extrema
///   solved_scene     what of a scene an answer shows, in these terms
///   cache            what was rendered before
///   visibility       not the picture, but what of it comes from which value
Reference render_reference(const Scene& scene, const Camera& camera, glm::ivec2 size, Answer answer,
                           double tolerance = default_tolerance, const Progress& progress = {});

/// The same of the formula itself, over the box of the scene's volume: what its grid was sampled from.
/// Formulas are fitted piece by piece with polynomials, to the rounding of double.
Reference render_reference(const FormulaField& field, const Scene& scene, const Camera& camera,
                           glm::ivec2 size, Answer answer, double tolerance = default_tolerance,
                           const Progress& progress = {});

/// The same code with all its arithmetic in 32-bit float: what float alone costs.
Reference render_reference_in_float(const Scene& scene, const Camera& camera, glm::ivec2 size, Answer answer,
                                    double tolerance = default_tolerance, const Progress& progress = {});

}  // namespace crest
