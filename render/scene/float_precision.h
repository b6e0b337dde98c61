#pragma once

#include <glm/vec2.hpp>
#include <string>
#include <vector>

#include "render/scene/scene.h"

namespace crest {

/// What a picture of the ray caster may be off by, in alpha, since it works in 32-bit float: positions are
/// rounded to 2^-24 of the box's diagonal, and where a material absorbs much within such a length, its
/// opacity goes with it. Four times the diagonal's rounding times the greatest extinction of the TF in the
/// field's range; the table of `crest stability` measures up to 3.3 times ("a surface in dense haze",
/// "spacing 1:1:1000"). 0 without DVR; a spike of no width does not count, nor one that is taken out of the
/// DVR.
double haze_rounding(const Scene& scene);

/// How wide a pixel is, in roundings of a position (2^-24 of the box's diagonal): in the volume's middle, or
/// half a diagonal away where the eye is nearer to it; in parallel projection everywhere. Where it is less
/// than some, edges are drawn a pixel off ("a field of view of 0.001 degrees, from near").
double pixel_roundings(const Grid& grid, const Camera& camera, glm::ivec2 size);

/// What was lost when the volume's values became 32-bit float, which no picture can bring back, as a sentence
/// for the person who looks at it; empty for ordinary volumes.
std::vector<std::string> volume_warnings(const Volume& volume);

/// The same, and the conditions under which 32-bit float measurably does not do for a picture of the ray
/// caster, each a sentence: what is so, and what it does. Empty for ordinary scenes.
std::vector<std::string> scene_warnings(const Scene& scene, const Camera& camera, glm::ivec2 size);

}  // namespace crest
