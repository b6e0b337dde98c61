#pragma once

#include <glm/vec4.hpp>
#include <vector>

#include "presets/transfer_function.h"

namespace crest {

/// What the TF holds on average over a bin of values, each value counting the same: emission (RGB, colour
/// times extinction) and extinction, for a length of one unit distance. Times the bin's width it is the
/// difference of the TF's antiderivatives between its ends, without their cancellation.
using MeanMaterial = glm::dvec4;

/// Of a bin on which colour and opacity a are linear. With t = 1 - a linear from 1 - a0 to 1 - a1, the
/// mean of -ln t and its first moment are closed forms; -ln t is capped at t = least_transmittance. To some
/// 1e-14.
MeanMaterial mean_material(const Classified& begin, const Classified& end);

/// Of `count` bins of the same width that make up the range, one after the other, in O(count + points):
/// whatever the TF does within one (a step, a spike) is in its mean. `range` has a width.
std::vector<MeanMaterial> mean_materials(const TransferFunction& tf, ValueRange range, int count);

}  // namespace crest
