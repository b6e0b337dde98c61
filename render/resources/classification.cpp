#include "render/resources/classification.h"

namespace crest {
namespace {

struct ClassificationKey {
  TransferFunction tf;
  ValueRange surfaces;
  bool operator==(const ClassificationKey&) const = default;
};

}  // namespace

const Classification& classification_of(KeyedCache& held, const Scene& scene) {
  const ClassificationKey key{scene.tf, surface_range(scene)};
  const std::size_t bytes = 4 * scene.tf.points.size() * sizeof(ControlPoint);
  return held.get(key, bytes, [&] { return classify(key.tf, key.surfaces); });
}

}  // namespace crest
