#pragma once

#include <vector>

#include "presets/peaks.h"
#include "render/volume/volume.h"

namespace crest {

/// The units in which the GPU holds a field: (value - base) * scale. Interpolation rounds to the digits of
/// what is interpolated, so that a field of 1e6 to 1e6+1 would come out in 16 steps, and products of values
/// near 1e-30 vanish; taken from `base` and with `scale` a power of two, no value loses a digit (Sterbenz's
/// lemma), and what lies between them gains them.
struct StoredUnits {
  double base = 0, scale = 1;

  bool is_identity() const { return base == 0 && scale == 1; }
  double stored(double value) const { return (value - base) * scale; }
  ValueRange stored(ValueRange range) const { return {stored(range.min), stored(range.max)}; }
  TransferFunction stored(TransferFunction tf) const;
  std::vector<Peak> stored(std::vector<Peak> peaks) const;
  float stored(float value) const { return float(stored(double(value))); }
};

/// For a field of this range: its end nearest to zero as the base, if all of the range lies further from zero
/// than it is wide; a scale other than 1 if the width is beyond 2^-40 to 2^40.
StoredUnits stored_units(ValueRange field);

/// Of a volume's texture: where its values are whole (volume/whole_values.h), the numbers of their steps.
StoredUnits stored_units(const Volume& volume);

}  // namespace crest
