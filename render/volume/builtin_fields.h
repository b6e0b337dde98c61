#pragma once

#include <cstdint>
#include <utility>

#include "render/volume/builtin.h"
#include "render/volume/dual.h"

namespace crest {

/// The field of a formula that takes a Point of plain or of dual numbers.
template <class Formula>
FormulaField field_of(Formula formula) {
  return {[formula](glm::dvec3 p) -> double { return formula(plain_point(p)); },
          [formula](glm::dvec3 p) -> glm::dvec3 { return Dual(formula(dual_point(p))).gradient; }};
}

struct PlumeShape {
  double decades = 5;     ///< powers of ten from the core to the rim
  double turbulence = 1;  ///< how far the noise moves the column
};
FormulaField plume_field(const PlumeShape& shape, std::uint64_t seed);

struct VesselShape {
  double radius = 0.09;  ///< of the trunk
  int generations = 6;   ///< of branches, the trunk among them
};
FormulaField vessel_field(const VesselShape& shape, std::uint64_t seed);

struct NoiseBand {
  double low = 1, high = 4;  ///< frequencies, in cycles a unit
};
FormulaField noise_field(const NoiseBand& band, std::uint64_t seed);

}  // namespace crest
