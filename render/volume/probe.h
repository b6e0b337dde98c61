#pragma once

#include <optional>

#include "render/volume/filter.h"
#include "render/volume/volume.h"

namespace crest {

/// The value of a filter's field at a place in the volume's box, each axis from 0 to 1 (clamped), in double.
/// Nothing where the filter reaches a point without a value.
std::optional<double> value_at(const Volume& volume, const FieldFilter& filter, glm::dvec3 place);

}  // namespace crest
