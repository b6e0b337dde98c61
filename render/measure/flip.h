#pragma once

#include <vector>

#include "render/files/image.h"

namespace crest {

/// What FLIP takes the viewer to see by default: a 4K monitor, 0.7 m wide, from 0.7 m away.
inline constexpr double default_pixels_per_degree = 67.02064327658226;  // 0.7 * 3840 / 0.7 * pi / 180

/// LDR-FLIP (Andersson et al., "FLIP: A Difference Evaluator for Alternating Images", HPG 2020): in [0, 1],
/// by pixel, how much a person notices who flips between the two pictures. Their RGB is display-referred
/// sRGB, clamped to [0, 1]; alpha has no part in it, so put them over their background first. The sizes
/// agree.
std::vector<float> flip_map(const Image& reference, const Image& test,
                            double pixels_per_degree = default_pixels_per_degree);

}  // namespace crest
