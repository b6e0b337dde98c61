#pragma once

#include <map>
#include <optional>

#include "render/measure/image_error.h"

namespace crest {

/// `integral` of a scene's own field.
ExactAnswer own_integral(const Rendering& scene);

/// The difference of an answer's exact picture from that of own_integral(): the mode's and the filter's, not
/// an error. Nothing without both, nor of the integral itself.
std::optional<ImageError> model_difference(const std::map<ExactAnswer, Reference>& exact,
                                           const ExactAnswer& answer, const Rendering& scene);

}  // namespace crest
