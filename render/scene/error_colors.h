#pragma once

#include <glm/vec3.hpp>
#include <span>

namespace crest {

/// Pictures of errors show a pixel's largest channel difference by its logarithm, from the scale's first
/// colour to its last. All have this one scale, so that they can be compared.
inline constexpr double least_shown_error = 1e-5, most_shown_error = 1;

/// The scale's colours, at equal distances: matplotlib's "inferno", even in lightness, and readable in grey
/// and by the colour-blind.
std::span<const glm::vec3> error_scale();

glm::vec3 error_color(double error);

}  // namespace crest
