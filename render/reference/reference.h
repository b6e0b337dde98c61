#pragma once

#include <cstdint>
#include <functional>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <vector>

#include "render/image.h"
#include "render/reference/answer.h"
#include "render/scene.h"
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

/// Solves every pixel's ray to `tolerance` (absolute, in each channel), on all cores. Step, placement,
/// shading and early termination have no part in it; the clip box has. Throws Error, Cancelled.
///
/// In a cell the trilinear field along a ray is a cubic. The ray is cut where this enters or leaves a cell,
/// turns round, or meets a control point's value, the opacity cap or a surface's value; in between everything
/// is smooth, and is integrated by Gauss-Legendre quadrature in as many panels as the tolerance takes.
Reference render_reference(const Scene& scene, const Camera& camera, glm::ivec2 size, Answer answer,
                           double tolerance = 1e-10, const Progress& progress = {});

/// The same of the formula itself, over the box of the scene's volume: what its grid was sampled from.
/// Formulas are fitted piece by piece with polynomials, to the rounding of double.
Reference render_reference(const FormulaField& field, const Scene& scene, const Camera& camera,
                           glm::ivec2 size, Answer answer, double tolerance = 1e-10,
                           const Progress& progress = {});

/// The same code with all its arithmetic in 32-bit float: what float alone costs.
Reference render_reference_in_float(const Scene& scene, const Camera& camera, glm::ivec2 size, Answer answer,
                                    double tolerance = 1e-10, const Progress& progress = {});

}  // namespace crest
