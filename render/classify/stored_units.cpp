#include "render/classify/stored_units.h"

#include <cmath>

#include "render/volume/whole_values.h"

namespace crest {

TransferFunction StoredUnits::stored(TransferFunction tf) const {
  for (ControlPoint& point : tf.points) point.value = stored(point.value);
  tf.plateau_width *= scale;
  return tf;
}

std::vector<Peak> StoredUnits::stored(std::vector<Peak> peaks) const {
  for (Peak& peak : peaks) {
    peak.value = stored(peak.value);
    peak.width *= scale;
  }
  return peaks;
}

StoredUnits stored_units(ValueRange field) {
  constexpr int ordinary_exponent = 40;
  StoredUnits units;
  if (field.min > 0 && field.min >= field.width()) units.base = field.min;
  if (field.max < 0 && -field.max >= field.width()) units.base = field.max;
  int exponent = 0;
  std::frexp(field.width(), &exponent);
  if (std::abs(exponent) > ordinary_exponent) units.scale = std::ldexp(1.0, -exponent);
  return units;
}

StoredUnits stored_units(const Volume& volume) {
  if (const auto whole = whole_values(volume)) return {whole->base, 1 / whole->step};
  return stored_units(volume.statistics.range);
}

}  // namespace crest
