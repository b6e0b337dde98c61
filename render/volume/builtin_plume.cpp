#include <numbers>

#include "render/volume/builtin_fields.h"
#include "render/volume/gradient_noise.h"

namespace crest {

/// A column that rises along z from a narrow source, widens, sways, and breaks up into eddies: a Gaussian
/// profile of height-dependent width, in coordinates that noise has moved. The core is smooth; the rim, where
/// the value has fallen by decades, is all wisps.
FormulaField plume_field(const PlumeShape& shape, std::uint64_t seed) {
  const double decades = shape.decades * std::numbers::ln10, turbulence = shape.turbulence;
  return field_of([=](const auto& p) {
    using T = std::decay_t<decltype(p.x)>;
    const T height = (p.z + 1.0) * 0.5;
    const T width = 0.07 + height * 0.33;
    // Eddies grow with the column; they are carried upwards, so they are sheared along z.
    const Point<T> eddy{p.x * 2.2, p.y * 2.2, p.z * 1.6};
    const T reach = (0.03 + height * 0.27) * turbulence;
    const T x = p.x + reach * fractal_noise(eddy, 4, seed * 64);
    const T y = p.y + reach * fractal_noise(eddy, 4, seed * 64 + 16);
    const T radial = (x * x + y * y) / (width * width);
    const T wisps = fractal_noise(Point<T>{x * 4.0, y * 4.0, p.z * 3.0}, 3, seed * 64 + 32);
    const T fall = (radial * exp(wisps * turbulence) + height * height * 0.5) * 0.25;
    return exp(fall / sqrt(sqrt(1.0 + fall * fall * fall * fall)) *
               -decades);  // levels off after the decades
  });
}

}  // namespace crest
