#pragma once

#include "render/classify/classification.h"
#include "render/classify/occupancy.h"
#include "render/gl/handle.h"
#include "render/resources/keyed_cache.h"
#include "render/scene/scene.h"
#include "render/shader_inputs/features.h"
#include "render/volume/bricks.h"
#include "render/volume/clip.h"

namespace crest {

/// What of a scene may show somewhere: the parts of it that the features name, through the tables' blur.
struct ShownParts {
  const Scene& scene;
  const Classification& classification;
  const Features& features;  ///< only dvr, base_tf, peaks, skipping and adaptive are looked at
  const TableBlur& blur;     ///< as in Shown (classify/occupancy.h)
};

/// The share of the macrocells that may show something. Held are the macrocells, by volume and filter, and
/// which of them show something, by what is shown.
double occupied_share(KeyedCache& held, const ShownParts& shown);

/// For features.skipping and features.adaptive: a texel (R8I) a macrocell. Where features.skipping, it is how
/// far away the nearest one of the other kind is, negative where nothing in it shows (`distances` in
/// classify/cell_boxes.h); where features.adaptive and it is not negative, how many steps are joined into
/// one.
GLuint macrocell_texture(KeyedCache& held, const ShownParts& shown);

/// Boxes in world units that hold all macrocells in which something may show.
const std::vector<Box>& shown_boxes(KeyedCache& held, const ShownParts& shown);

/// The bricks (volume/bricks.h) that a picture reads: those around the macrocells in which something may
/// show, where features.skipping; else all. `longest_step` lies between two samples next to each other, in
/// smallest spacings.
const std::shared_ptr<const BrickSet>& shown_bricks(KeyedCache& held, const ShownParts& shown,
                                                    double longest_step);

/// The side of a macrocell, in cells of the grid.
inline int macrocell_side(const Volume& volume) { return macrocell_side(volume.grid, volume.statistics); }

}  // namespace crest
