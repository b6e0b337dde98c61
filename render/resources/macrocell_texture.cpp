#include "render/resources/macrocell_texture.h"

#include <cmath>

#include "render/classify/cell_boxes.h"
#include "render/resources/volume_key.h"
#include "render/resources/volume_texture.h"

namespace crest {
namespace {

using SharedOccupancy = std::shared_ptr<const Occupancy>;

struct MacrocellsKey : VolumeKey {
  MacrocellsKey(const std::shared_ptr<const Volume>& volume, const FieldFilter& f)
      : VolumeKey(volume), filter(f) {}
  FieldFilter filter;
  bool operator==(const MacrocellsKey&) const = default;
};

struct OccupancyKey : VolumeKey {
  explicit OccupancyKey(const ShownParts& shown)
      : VolumeKey(shown.scene.volume),
        dvr_filter(crest::dvr_filter(shown.scene.rendering)),
        root_filter(crest::root_filter(shown.scene.rendering)) {
    const Classification& c = shown.classification;
    if (shown.features.dvr) tf = shown.features.base_tf ? c.base : c.tf;
    if (shown.features.dvr) blur = shown.blur;
    if (shown.features.peaks) surfaces = c.surfaces;
  }
  FieldFilter dvr_filter, root_filter;
  std::optional<TransferFunction> tf;
  TableBlur blur;
  std::optional<std::vector<Peak>> surfaces;
  bool operator==(const OccupancyKey&) const = default;
};

/// What is made of an occupancy is the same wherever its cells are: most edits of a TF change none.
struct CellsKey : VolumeKey {
  CellsKey(const std::shared_ptr<const Volume>& volume, std::shared_ptr<const Occupancy> shown)
      : VolumeKey(volume), occupancy(std::move(shown)) {}
  std::shared_ptr<const Occupancy> occupancy;  ///< null where nothing is skipped
  bool operator==(const CellsKey& other) const {
    return VolumeKey::operator==(other) && bool(occupancy) == bool(other.occupancy) &&
           (occupancy == other.occupancy || occupancy->cells == other.occupancy->cells);
  }
};

struct BricksKey : CellsKey {
  BricksKey(const std::shared_ptr<const Volume>& volume, SharedOccupancy shown, int points_beyond)
      : CellsKey(volume, std::move(shown)), reach(points_beyond) {}
  int reach;
  bool operator==(const BricksKey&) const = default;
};

struct TexelsKey : CellsKey {
  TexelsKey(const ShownParts& shown, std::shared_ptr<const Occupancy> occupied)
      : CellsKey(shown.scene.volume, std::move(occupied)),
        dvr_filter(crest::dvr_filter(shown.scene.rendering)),
        adaptive(shown.features.adaptive) {}
  FieldFilter dvr_filter;
  bool adaptive;
  bool operator==(const TexelsKey&) const = default;
};

std::size_t macrocell_count(const Volume& volume) {
  const glm::ivec3 dims = macrocell_dims(volume.grid, macrocell_side(volume));
  return std::size_t(dims.x) * std::size_t(dims.y) * std::size_t(dims.z);
}

const Macrocells& macrocells(KeyedCache& held, const std::shared_ptr<const Volume>& volume,
                             const FieldFilter& filter) {
  return held.get(MacrocellsKey(volume, filter), macrocell_count(*volume) * 3 * sizeof(float),
                  [&] { return build_macrocells(*volume, filter, macrocell_side(*volume)); });
}

const SharedOccupancy& occupancy(KeyedCache& held, const ShownParts& parts) {
  const auto& volume = parts.scene.volume;
  const OccupancyKey key(parts);
  return held.get(key, macrocell_count(*volume), [&] {
    const auto shared = [](Occupancy found) { return std::make_shared<const Occupancy>(std::move(found)); };
    const auto shown_in = [&](const FieldFilter& filter, const Shown& shown) {
      return find_occupancy(macrocells(held, volume, filter), shown,
                            field_range(filter, volume->statistics.range));
    };
    const TransferFunction* tf = key.tf ? &*key.tf : nullptr;
    const std::vector<Peak>* surfaces = key.surfaces ? &*key.surfaces : nullptr;
    if (key.dvr_filter == key.root_filter || !surfaces)
      return shared(shown_in(key.dvr_filter, {tf, key.blur, surfaces}));
    return shared(either(shown_in(key.dvr_filter, {tf, key.blur, nullptr}),
                         shown_in(key.root_filter, {nullptr, {}, surfaces})));
  });
}

/// `shown` is null where nothing is skipped.
gl::TextureHandle upload(const Macrocells& cells, const Occupancy* shown, bool adaptive,
                         double volume_deviation) {
  std::vector<std::int8_t> texels(cells.count(), 1);
  if (shown) texels = distances(shown->cells, cells.dims);
  if (adaptive) {
    const std::vector<std::int8_t> multiples = step_multiples(cells, volume_deviation);
    for (std::size_t i = 0; i < texels.size(); ++i)
      if (texels[i] > 0) texels[i] = multiples[i];
  }
  return upload_3d(cells.dims, GL_R8I, GL_RED_INTEGER, GL_BYTE, texels.data(), GL_NEAREST);
}

}  // namespace

double occupied_share(KeyedCache& held, const ShownParts& shown) { return occupancy(held, shown)->share; }

GLuint macrocell_texture(KeyedCache& held, const ShownParts& shown) {
  const auto& volume = shown.scene.volume;
  const SharedOccupancy occupied = shown.features.skipping ? occupancy(held, shown) : nullptr;
  return held
      .get(TexelsKey(shown, occupied), macrocell_count(*volume),
           [&] {
             return upload(macrocells(held, volume, dvr_filter(shown.scene.rendering)), occupied.get(),
                           shown.features.adaptive, std::sqrt(volume->statistics.variance));
           })
      .id();
}

const std::shared_ptr<const BrickSet>& shown_bricks(KeyedCache& held, const ShownParts& shown,
                                                    double longest_step) {
  const auto& volume = shown.scene.volume;
  // Beyond a macrocell, in points: that of filters and differences, and of the sample behind the last one in
  // it. In steps, since the longest one grows with the camera, and what is held would be made anew with it
  constexpr int least = 3, multiple = 8;
  const glm::ivec3 points = volume->grid.dims;
  const double most = std::max({points.x, points.y, points.z});
  const int longest = int(std::ceil(std::min(std::max(longest_step, 1.0), most)));
  const int reach = (least + longest + multiple - 1) / multiple * multiple;
  const SharedOccupancy occupied = shown.features.skipping ? occupancy(held, shown) : nullptr;
  return held.get(BricksKey(volume, occupied, reach), brick_count(volume->grid), [&] {
    return std::make_shared<const BrickSet>(
        occupied ? bricks_around(occupied->cells, volume->grid, macrocell_side(*volume), reach)
                 : BrickSet(brick_count(volume->grid), 1));
  });
}

const std::vector<Box>& shown_boxes(KeyedCache& held, const ShownParts& shown) {
  const auto& volume = shown.scene.volume;
  const SharedOccupancy& occupied = occupancy(held, shown);
  return held.get(CellsKey(volume, occupied), macrocell_count(*volume), [&] {
    const Grid& grid = volume->grid;
    const int side = macrocell_side(*volume);
    const glm::dvec3 size = grid.spacing * double(side);
    std::vector<Box> boxes;
    for (const CellBox& cells : occupied_boxes(occupied->cells, macrocell_dims(grid, side)))
      boxes.push_back({grid.box_min() + size * glm::dvec3(cells.first),
                       grid.box_min() + size * (glm::dvec3(cells.last) + 1.0)});
    return boxes;
  });
}

}  // namespace crest
