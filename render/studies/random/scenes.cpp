#include "render/studies/random/scenes.h"

#include "render/studies/random/kinds.h"

namespace crest {
namespace {

/// For each scene one of `count` kinds, each equally often, in an order by chance.
std::vector<std::size_t> spread(Dice& dice, std::size_t count) {
  std::vector<std::size_t> kinds;
  for (std::size_t i = 0; i < random_scene_count; ++i) kinds.push_back(i % count);
  dice.shuffle(kinds);
  return kinds;
}

}  // namespace

std::vector<RandomScene> random_scenes(std::uint64_t seed) {
  Dice dice{Random(Random::mix(seed))};
  const auto fields = spread(dice, field_kinds().size()), features = spread(dice, feature_kinds().size()),
             views = spread(dice, view_kinds().size());
  std::vector<RandomScene> scenes;
  for (std::size_t i = 0; i < random_scene_count; ++i) {
    const FieldKind& field = field_kinds()[fields[i]];
    const FeatureKind& feature = feature_kinds()[features[i]];
    const ViewKind& view = view_kinds()[views[i]];
    RandomScene random{
        std::string(field.name), std::string(feature.name), std::string(view.name), field.labels, {}, {}};
    Dice own{Random(dice.random.bits())};
    random.scene.volume = field.make(own);
    random.scene.tf = feature.make(own, *random.scene.volume, field.labels);
    random.camera = view.make(own, random.scene.volume->grid);
    scenes.push_back(std::move(random));
  }
  return scenes;
}

}  // namespace crest
